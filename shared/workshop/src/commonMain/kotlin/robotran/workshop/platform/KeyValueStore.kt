package robotran.workshop.platform

/** Named texts that persist however the app ends. */
typealias KeyValueStore = robotran.documents.KeyValueStore

/** Keeps texts in memory while the app runs. */
typealias MemoryStore = robotran.documents.MemoryKeyValueStore

/** The kind of a file, by its extension. */
typealias FileKind = robotran.documents.FileKind
