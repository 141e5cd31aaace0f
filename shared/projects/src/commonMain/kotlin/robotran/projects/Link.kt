package robotran.projects

import kotlinx.serialization.json.JsonElement
import robotran.json.JsonLimits
import robotran.json.readJson
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.language.grouped
import robotran.projects.messages.LinkMessages
import robotran.projects.messages.ProjectMessages
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.elementOf
import robotran.world.file.readWorld
import kotlin.io.encoding.Base64

/** The result of creating a link. */
sealed interface LinkCreation {
    /** @property fragment follows the page's address, such as `#w=a...`. */
    data class Made(val fragment: String) : LinkCreation

    /** The content is too long for a link; [message] says so in one sentence and suggests an alternative. */
    data class TooLong(val message: String) : LinkCreation
}

/** The result of opening a link. */
sealed interface LinkResult {
    data class OfWorld(val world: World) : LinkResult

    data class OfProject(val project: Project) : LinkResult

    data class OfCourse(val course: Course) : LinkResult

    /** The link is invalid; [message] is one sentence with the reason. */
    data class Rejected(val message: String) : LinkResult
}

/**
 * The link to [world]: its file, deflated and encoded in characters that every program accepts in an address. No server
 * ever receives it, because a browser does not send the part after the `#`.
 *
 * @param language the language of the message if it is too long.
 */
suspend fun linkOf(world: World, language: Language): LinkCreation =
    linkOf(LinkKind.WORLD, elementOf(world), language) { it::worldTooLong }

/** The same for [project], without its [files][ProjectRobot.files]. The message tells if its pictures make it too long. */
suspend fun linkOf(project: Project, language: Language): LinkCreation =
    linkOf(LinkKind.PROJECT, elementOf(project.withoutFiles()), language) {
        val isByPictures = fits(fragmentOf(LinkKind.PROJECT, elementOf(withoutPictures(project.withoutFiles()))))
        if (isByPictures) it::projectPicturesTooLong else it::projectTooLong
    }

/** The same for [course], with all its assignments. */
suspend fun linkOf(course: Course, language: Language): LinkCreation =
    linkOf(LinkKind.COURSE, elementOf(course), language) {
        val bare = course.copy(assignments = course.assignments.map(::withoutPictures))
        val isByPictures = fits(fragmentOf(LinkKind.COURSE, elementOf(bare)))
        if (isByPictures) it::coursePicturesTooLong else it::courseTooLong
    }

private fun withoutPictures(project: Project): Project =
    project.copy(assignment = project.assignment?.copy(pictures = emptyList()))

/**
 * The short link to [handIn], for a QR code: without the assignment's world, see [writeCompactHandIn]. Only
 * [openHandInLink] opens it.
 */
suspend fun handInLinkOf(handIn: Project, language: Language): LinkCreation =
    linkOf(LinkKind.HAND_IN, handInElementOf(handIn.withoutFiles()), language) { it::projectTooLong }

/**
 * Opens a link from [linkOf].
 *
 * @param link a whole address with a fragment, or the fragment alone, or a text with one, see [linksIn]. Returns quickly
 * for any text.
 * @param language the language of error messages.
 */
suspend fun openLink(link: String, language: Language): LinkResult = openLink(link, null, language)

/**
 * The same for any link that a pupil hands in, also one from [handInLinkOf].
 *
 * @param world of the assignment, for a link without a world.
 */
suspend fun openHandInLink(link: String, world: World, language: Language): LinkResult = openLink(link, world, language)

private suspend fun openLink(link: String, given: World?, language: Language): LinkResult {
    val messages = ProjectMessages.of(language)
    val fragment = (linksIn(link).firstOrNull()?.link ?: link.trim()).substringAfter('#')
    val kind = LinkKind.entries.firstOrNull { fragment.startsWith(it.start) }
        ?: return LinkResult.Rejected(messages.notALink())
    if (kind == LinkKind.HAND_IN && given == null) return LinkResult.Rejected(messages.handInLink())
    if (fragment.length >= LIMIT) return LinkResult.Rejected(messages.linkTooLong(language.grouped(LIMIT)))
    val data = fragment.removePrefix(kind.start)
    if (data.isNotEmpty() && !data.startsWith(SCHEME) && data[0] in 'b'..'z') {
        return LinkResult.Rejected(messages.newerLink())
    }
    val bytes = if (data.startsWith(SCHEME)) unpack(data.removePrefix(SCHEME)) else null
    return when {
        bytes == null -> LinkResult.Rejected(messages.linkBroken())
        kind == LinkKind.WORLD -> resultOf(readWorld(bytes, language), messages)
        kind == LinkKind.PROJECT -> resultOf(readProject(bytes, language), messages)
        kind == LinkKind.COURSE -> resultOf(readCourse(bytes, language), messages)
        else -> resultOf(resultOf(readJson(bytes, language) { projectIn(it, given) }), messages)
    }
}

/** Whether [text] looks like a link to a course. */
fun isCourseLink(text: String): Boolean = kindOf(text) == LinkKind.COURSE

/** Whether [text] looks like a link to a hand-in without its world. */
fun isHandInLink(text: String): Boolean = kindOf(text) == LinkKind.HAND_IN

private fun kindOf(text: String): LinkKind? {
    val link = writtenLinksIn(text).firstOrNull()?.readings?.last() ?: return null
    return LinkKind.entries.firstOrNull { link.startsWith("#${it.start}") }
}

/** Whether nothing of [link], `#p=a...`, is missing, and nothing too much. */
internal suspend fun isWholeLink(link: String): Boolean {
    val data = link.substringAfter('=')
    return data.startsWith(SCHEME) && unpack(data.removePrefix(SCHEME)) != null
}

private enum class LinkKind(val start: String) { WORLD("w="), PROJECT("p="), COURSE("c="), HAND_IN("h=") }

/** @param tooLong chooses the message for a length and the limit. */
private suspend fun linkOf(
    kind: LinkKind,
    element: JsonElement,
    language: Language,
    tooLong: suspend (LinkMessages) -> (String, String) -> String,
): LinkCreation {
    val fragment = fragmentOf(kind, element)
    if (fits(fragment)) return LinkCreation.Made(fragment)
    val message = tooLong(ProjectMessages.of(language))
    return LinkCreation.TooLong(message(language.grouped(fragment.length), language.grouped(LIMIT)))
}

private fun fits(fragment: String): Boolean = fragment.length <= LIMIT

private suspend fun fragmentOf(kind: LinkKind, element: JsonElement): String {
    val bytes = writeCompactJson(element).encodeToByteArray()
    return "#${kind.start}$SCHEME${LETTERS.encode(deflate(bytes))}"
}

private suspend fun unpack(data: String): ByteArray? {
    val compressed = try {
        LETTERS.decode(data)
    } catch (_: IllegalArgumentException) {
        return null
    }
    return inflate(compressed, JsonLimits.MAXIMUM_BYTES)
}

private fun resultOf(result: WorldFileResult, messages: LinkMessages): LinkResult = when (result) {
    is WorldFileResult.Success -> LinkResult.OfWorld(result.world)
    is WorldFileResult.Failure -> LinkResult.Rejected(messages.linkUnusable(result.message))
}

private fun resultOf(result: ProjectFileResult, messages: LinkMessages): LinkResult = when (result) {
    is ProjectFileResult.Success -> LinkResult.OfProject(result.project)
    is ProjectFileResult.Failure -> LinkResult.Rejected(messages.linkUnusable(result.message))
}

private fun resultOf(result: CourseFileResult, messages: LinkMessages): LinkResult = when (result) {
    is CourseFileResult.Success -> LinkResult.OfCourse(result.course)
    is CourseFileResult.Failure -> LinkResult.Rejected(messages.linkUnusable(result.message))
}

/**
 * The encoding of a link: the file's compact JSON, raw deflate, Base64 with `-` and `_` and without `=`. Another
 * encoding would get another letter.
 */
private const val SCHEME = "a"
private const val LIMIT = ProjectLimits.MAXIMUM_LINK_CHARACTERS
private val LETTERS = Base64.UrlSafe.withPadding(Base64.PaddingOption.ABSENT)
