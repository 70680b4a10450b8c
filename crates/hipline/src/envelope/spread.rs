//! Independent jobs, by as many threads as there are.
//!
//! Exact numbers remember roots that they were asked for, so each thread has planes of its own. What a job does depends on its item alone,
//! so neither results nor counts depend on the number of threads.

use super::Envelope;

impl<'a> Envelope<'a> {
    /// The results of a job for each of some items, in order.
    #[cfg(feature = "parallel")]
    pub(super) fn spread<T: Sync, R: Send>(
        &mut self,
        items: &[T],
        job: impl Fn(&mut Envelope<'a>, &T) -> R + Sync,
    ) -> Vec<R> {
        use super::Count;
        use crate::predicates::Planes;
        use std::sync::{
            Mutex,
            atomic::{AtomicUsize, Ordering},
        };

        /// Fewer are not worth another thread.
        const FEW: usize = 16;
        /// What a thread takes at once: this part of all.
        const PART: usize = 64;
        let threads = rayon::current_num_threads().min(items.len() / FEW);
        if threads < 2 || self.seen.is_some() {
            return items.iter().map(|item| job(self, item)).collect();
        }
        let grain = items.len().div_ceil(PART);
        let next = AtomicUsize::new(0);
        let done = Mutex::new(Vec::new());
        let shared = &self.shared;
        rayon::scope(|scope| {
            for _ in 0..threads {
                scope.spawn(|_| {
                    let mut own = Envelope {
                        shared: shared.clone(),
                        planes: Planes::new(shared.figure, &[]),
                        count: Count::default(),
                        twins: Vec::new(),
                        seen: None,
                    };
                    let mut results = Vec::new();
                    loop {
                        let first = next.fetch_add(grain, Ordering::Relaxed);
                        if first >= items.len() {
                            break;
                        }
                        let last = (first + grain).min(items.len());
                        let mine = items[first..last].iter().map(|item| job(&mut own, item));
                        results.push((first, mine.collect::<Vec<R>>()));
                    }
                    let rungs = own.planes.rungs.get();
                    let all = (results, own.count, rungs, own.twins);
                    done.lock().expect("no thread panics here").push(all);
                });
            }
        });
        let mut results = Vec::new();
        let mut rungs = self.planes.rungs.get();
        for (some, count, own, twins) in done.into_inner().expect("no thread panics here") {
            results.extend(some);
            self.count.add(&count);
            self.twins.extend(twins);
            rungs.by_f64 += own.by_f64;
            rungs.by_double_double += own.by_double_double;
            rungs.by_wide += own.by_wide;
            rungs.by_exact += own.by_exact;
        }
        self.planes.rungs.set(rungs);
        results.sort_by_key(|(first, _)| *first);
        results.into_iter().flat_map(|(_, some)| some).collect()
    }

    /// The results of a job for each of some items, in order.
    #[cfg(not(feature = "parallel"))]
    pub(super) fn spread<T, R>(
        &mut self,
        items: &[T],
        job: impl Fn(&mut Envelope<'a>, &T) -> R,
    ) -> Vec<R> {
        items.iter().map(|item| job(self, item)).collect()
    }
}
