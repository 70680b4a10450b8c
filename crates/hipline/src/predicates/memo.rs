//! What was found out about things lately, where finding it is dear, or it takes much room.

use std::cell::RefCell;

/// As many answers are kept at least, where there are so many.
const PLACES: usize = 1 << 8;

/// The last answers: for each number its place, where others come, too.
#[derive(Debug)]
pub(crate) struct Memo<T>(RefCell<Vec<Option<(u32, T)>>>);

impl<T> Default for Memo<T> {
    fn default() -> Self {
        Self(RefCell::default())
    }
}

impl<T: Clone> Memo<T> {
    /// What is known of a number among so many, or else is found. About one answer in `every` is kept; count and
    /// `every` are always the same.
    pub(super) fn get(
        &self,
        number: u32,
        [count, every]: [usize; 2],
        find: impl FnOnce() -> T,
    ) -> T {
        let places = (count / every).next_power_of_two().max(PLACES);
        let place = number as usize % places;
        if let Some(Some((of, known))) = self.0.borrow().get(place)
            && *of == number
        {
            return known.clone();
        }
        let found = find();
        let mut all = self.0.borrow_mut();
        if all.len() <= place {
            all.resize(count.clamp(place + 1, places), None);
        }
        all[place] = Some((number, found.clone()));
        found
    }
}
