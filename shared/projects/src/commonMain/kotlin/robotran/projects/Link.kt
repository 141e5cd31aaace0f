package robotran.projects

import kotlinx.serialization.json.JsonElement
import robotran.json.JsonLimits
import robotran.json.writeCompactJson
import robotran.language.Language
import robotran.projects.messages.LinkMessages
import robotran.projects.messages.ProjectMessages
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.elementOf
import robotran.world.file.readWorld
import kotlin.io.encoding.Base64

/** A link that was made. */
sealed interface LinkMaking {
    /** @property fragment what stands behind the page's address, such as `#w=a...`. */
    data class Made(val fragment: String) : LinkMaking

    /** There is too much for a link; [message] says so in one sentence and what to do instead. */
    data class TooLong(val message: String) : LinkMaking
}

/** What came of opening a link. */
sealed interface LinkResult {
    data class OfWorld(val world: World) : LinkResult

    data class OfProject(val project: Project) : LinkResult

    /** The link cannot be used; [message] is one sentence that says why. */
    data class Rejected(val message: String) : LinkResult
}

/**
 * The link to [world]: its file, deflated, in letters that every program takes for part of an address. Nothing of it is
 * ever sent to a server, since a browser keeps to itself what is behind the `#`.
 *
 * @param language what is told in if it is too long.
 */
suspend fun linkOf(world: World, language: Language = Language.ENGLISH): LinkMaking =
    linkOf(LinkKind.WORLD, elementOf(world), ProjectMessages.of(language)::worldTooLong)

/** The same for [project]. */
suspend fun linkOf(project: Project, language: Language = Language.ENGLISH): LinkMaking =
    linkOf(LinkKind.PROJECT, elementOf(project), ProjectMessages.of(language)::projectTooLong)

/**
 * Opens a link that [linkOf] has made.
 *
 * @param link a whole address with a fragment, or the fragment alone, with blanks around it or none. Whatever it is,
 * this ends quickly and with a result.
 * @param language what a refusal is told in.
 */
suspend fun openLink(link: String, language: Language = Language.ENGLISH): LinkResult {
    val messages = ProjectMessages.of(language)
    val fragment = link.trim().substringAfter('#')
    val kind = LinkKind.entries.firstOrNull { fragment.startsWith(it.start) }
        ?: return LinkResult.Rejected(messages.notALink())
    if (link.length > ProjectLimits.MAXIMUM_LINK_CHARACTERS) {
        return LinkResult.Rejected(messages.linkTooLong(ProjectLimits.MAXIMUM_LINK_CHARACTERS))
    }
    val data = fragment.removePrefix(kind.start)
    if (data.isNotEmpty() && !data.startsWith(SCHEME) &&
        data[0] in 'b'..'z'
    ) {
        return LinkResult.Rejected(messages.newerLink())
    }
    val bytes = if (data.startsWith(SCHEME)) unpack(data.removePrefix(SCHEME)) else null
    return when {
        bytes == null -> LinkResult.Rejected(messages.linkBroken())
        kind == LinkKind.WORLD -> resultOf(readWorld(bytes, language), messages)
        else -> resultOf(readProject(bytes, language), messages)
    }
}

/** Whether [text] looks like a link of Robotran's, or a part of one, and not like the name of a file. */
fun isLink(text: String): Boolean = LinkKind.entries.any { "#${it.start}" in text }

private enum class LinkKind(val start: String) { WORLD("w="), PROJECT("p=") }

private suspend fun linkOf(kind: LinkKind, element: JsonElement, tooLong: (Int, Int) -> String): LinkMaking {
    val bytes = writeCompactJson(element).encodeToByteArray()
    val fragment = "#${kind.start}$SCHEME${LETTERS.encode(deflate(bytes))}"
    if (fragment.length <= ProjectLimits.MAXIMUM_LINK_CHARACTERS) return LinkMaking.Made(fragment)
    return LinkMaking.TooLong(tooLong(fragment.length, ProjectLimits.MAXIMUM_LINK_CHARACTERS))
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
    is WorldFileResult.Loaded -> LinkResult.OfWorld(result.world)
    is WorldFileResult.Rejected -> LinkResult.Rejected(messages.linkUnusable(result.message))
}

private fun resultOf(result: ProjectFileResult, messages: LinkMessages): LinkResult = when (result) {
    is ProjectFileResult.Loaded -> LinkResult.OfProject(result.project)
    is ProjectFileResult.Rejected -> LinkResult.Rejected(messages.linkUnusable(result.message))
}

/**
 * Says how a link is packed: the file's shortest JSON, raw deflate, Base64 with `-` and `_` and without `=`. Another
 * way will have another letter.
 */
private const val SCHEME = "a"
private val LETTERS = Base64.UrlSafe.withPadding(Base64.PaddingOption.ABSENT)
