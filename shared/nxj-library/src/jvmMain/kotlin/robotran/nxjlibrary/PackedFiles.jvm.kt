package robotran.nxjlibrary

internal actual suspend fun packedClasses(): ByteArray = resource("nxj-classes.bin")

internal actual suspend fun packedSources(): ByteArray = resource("nxj-sources.bin")

// An absolute path, since Android's optimiser may move the class to another package.
private fun resource(name: String): ByteArray =
    checkNotNull(NxjLibrary::class.java.getResourceAsStream("/robotran/nxjlibrary/$name")) { "There is no $name" }
        .use { it.readBytes() }
