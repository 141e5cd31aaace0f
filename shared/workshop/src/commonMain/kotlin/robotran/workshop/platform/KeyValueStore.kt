package robotran.workshop.platform

/** Texts with names that survive the end of the app, whichever way it ends. */
typealias KeyValueStore = robotran.documents.KeyValueStore

/** Keeps texts as long as the app runs. */
typealias MemoryStore = robotran.documents.MemoryKeyValueStore

/** What a file holds, by the end of its name. */
typealias FileKind = robotran.documents.FileKind
