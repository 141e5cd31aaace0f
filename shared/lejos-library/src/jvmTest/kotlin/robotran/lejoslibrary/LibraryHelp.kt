package robotran.lejoslibrary

/** The help of all public classes by their names with slashes, in their order. */
internal val libraryHelp: Map<String, JavaHelp> = LejosLibrary.classNames.filter { '$' !in it }.sorted()
    .associateWith { JavaHelp(checkNotNull(LejosLibrary.source(it))) }.filterValues { it.isPublic }
