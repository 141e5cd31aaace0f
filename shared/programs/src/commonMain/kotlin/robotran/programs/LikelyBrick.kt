package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform

/**
 * The kind of brick that this program is for, or that it most likely is for if it names none: Java that prints with
 * `System.out` or uses classes of `java.util` that only leJOS NXJ has is for the brick with that. Null if nothing tells.
 */
fun likelyBrickOf(program: ProgramSource): BrickKind? = brickOf(program)
    ?: BrickKind.with(JavaPlatform.NXJ).takeIf { program is ProgramSource.Java && looksLikeNxj(program.files) }

/** A program that names both bricks is for none. */
private fun looksLikeNxj(files: List<SourceFile>): Boolean {
    val texts = files.map { withoutCommentsAndTexts(it.text) }
    return texts.none { BRICK_NAME.containsMatchIn(it) } && texts.any { text ->
        SYSTEM_STREAM.containsMatchIn(text) || (UTILITIES.containsMatchIn(text) && NXJ_UTILITY.containsMatchIn(text))
    }
}

private val SYSTEM_STREAM = Regex("""(?<![\w.$])(?:java\.lang\.)?System\s*\.\s*(?:out|err)\b""")

private val UTILITIES = Regex("""\bjava\.util\.""")

/** What leJOS on an RCX lacks in `java.util`. */
private val NXJ_UTILITY = Regex(
    """\b(?:Array(?:List|s)|Collection|Date|Enumeration|Hash(?:Map|Set)|Iterator|LinkedList|List|ListIterator|Map|""" +
        """NoSuchElementException|Properties|Set|StringTokenizer|Timer|TimerTask)\b""",
)
