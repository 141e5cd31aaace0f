package robotran.assignments.packaging

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonPrimitive
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.deflate
import robotran.projects.linkOf

/** A file of the built web site; [path] is relative to `index.html`. */
class SiteFile(val path: String, val bytes: ByteArray)

/** The standards for what learning platforms import: ADL's SCORM 1.2, and the 4th edition of SCORM 2004. */
enum class ScormVersion { SCORM_1_2, SCORM_2004 }

/** The result of making a package. */
sealed interface PackageResult {
    /** @property bytes of a zip file. */
    class Made(val bytes: ByteArray) : PackageResult

    /** An assignment is too long for a link; [message] is a sentence. */
    data class TooLong(val message: String) : PackageResult
}

/**
 * A package of [assignments] that learning platforms import and that needs nothing else: it contains the web site. Each
 * assignment is an item with its own score, completion and saved work.
 *
 * @param assignments at least one, as pupils get it.
 * @param site all files of the built web site, without those that are only compressed copies.
 */
suspend fun learningPackage(
    title: String,
    assignments: List<Project>,
    version: ScormVersion,
    site: List<SiteFile>,
    language: Language,
): PackageResult {
    val links = assignments.map { assignment ->
        when (val link = linkOf(assignment, language)) {
            is LinkCreation.Made -> link.fragment
            is LinkCreation.TooLong -> return PackageResult.TooLong(link.message)
        }
    }
    val content = wrapperTexts.map { (name, text) -> SiteFile(name, text.encodeToByteArray()) } +
        SiteFile(ASSIGNMENTS, assignmentsScript(links).encodeToByteArray()) +
        site.sortedBy { it.path }.map { SiteFile("$SITE_FOLDER/${it.path}", it.bytes) }
    val manifest = manifestOf(title, assignments, version, content.map { it.path })
    val files = listOf(SiteFile(MANIFEST, manifest.encodeToByteArray())) + content
    return PackageResult.Made(zipOf(files.map { entryOf(it) }))
}

private suspend fun entryOf(file: SiteFile): ZipEntry {
    val deflated = deflate(file.bytes)
    return ZipEntry(file.path, file.bytes, deflated = deflated.takeIf { it.size < file.bytes.size })
}

private fun assignmentsScript(links: List<String>): String =
    "globalThis.robotranAssignments = ${writeCompactJson(JsonArray(links.map(::JsonPrimitive)))};\n"

internal const val START_PAGE = "start.html"
private const val MANIFEST = "imsmanifest.xml"
private const val ASSIGNMENTS = "assignments.js"
private const val SITE_FOLDER = "site"
