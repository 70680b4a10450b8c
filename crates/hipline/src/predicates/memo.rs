//! What was found out about lines lately, where finding it is dear and it takes much room.

use std::cell::RefCell;

/// Answers about as many lines or planes are kept.
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
    /// What is known of a number among so many, or else is found.
    pub(super) fn get(&self, number: u32, count: usize, find: impl FnOnce() -> T) -> T {
        let place = number as usize % PLACES;
        if let Some(Some((of, known))) = self.0.borrow().get(place)
            && *of == number
        {
            return known.clone();
        }
        let found = find();
        let mut all = self.0.borrow_mut();
        if all.len() <= place {
            all.resize(count.clamp(place + 1, PLACES), None);
        }
        all[place] = Some((number, found.clone()));
        found
    }
}
