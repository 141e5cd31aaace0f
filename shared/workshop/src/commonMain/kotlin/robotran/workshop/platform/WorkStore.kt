package robotran.workshop.platform

/** Texts with names that survive the end of the app, whichever way it ends. */
typealias WorkStore = robotran.documents.WorkStore

/** Keeps texts as long as the app runs. */
typealias MemoryStore = robotran.documents.MemoryWorkStore

/** What a file holds, by the end of its name. */
typealias FileKind = robotran.documents.FileKind
