//! Typed ids and nothing else: this module never reads a coordinate.

macro_rules! id {
    ($(#[$doc:meta])* $name:ident, $letter:literal) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub struct $name(u32);

        impl $name {
            /// The id with the given index.
            ///
            /// # Panics
            /// If the index does not fit into 32 bits.
            #[must_use]
            pub fn new(index: usize) -> Self {
                Self(u32::try_from(index).expect("more than 2^32 elements"))
            }

            /// The position of the element in its list.
            #[must_use]
            pub const fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Debug::fmt(self, f)
            }
        }
    };
}

id!(
    /// A vertex of the input graph.
    VertexId, "v"
);
id!(
    /// An edge of the input graph.
    EdgeId, "e"
);
id!(
    /// A node of the skeleton.
    NodeId, "n"
);
id!(
    /// An arc of the skeleton.
    ArcId, "a"
);
id!(
    /// A face of the skeleton.
    FaceId, "f"
);
