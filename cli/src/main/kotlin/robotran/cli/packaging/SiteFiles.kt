package robotran.cli.packaging

import robotran.assignments.packaging.SiteFile
import robotran.siteserver.SiteServer
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isRegularFile
import kotlin.io.path.readBytes
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/**
 * All files of the built site in [folder], without those that are only compressed copies; null if there is no site, or
 * it cannot be read.
 */
fun readSiteFiles(folder: Path): List<SiteFile>? = try {
    folder.takeIf(SiteServer::hasSite)?.walk()
        ?.filter { it.isRegularFile() && it.extension !in COMPRESSED }
        ?.map { SiteFile(it.relativeTo(folder).invariantSeparatorsPathString, it.readBytes()) }
        ?.toList()
} catch (_: IOException) {
    null
}

private val COMPRESSED = listOf("br", "gz")
