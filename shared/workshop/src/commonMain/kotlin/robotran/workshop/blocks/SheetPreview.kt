package robotran.workshop.blocks

import androidx.compose.runtime.Immutable
import robotran.blockediting.scale
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import robotran.robolang.words.ValueUse
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.inEnglish
import robotran.world.geometry.Pose
import kotlin.math.round

/** What the number that the pupil edits would do now, to show it on the sheet. */
@Immutable
sealed interface SheetPreview {
    /** Where the robot stands. */
    val pose: Pose

    /** The number as it is written in the program. */
    val text: String

    /**
     * The robot drives straight.
     *
     * @property centimetres the way, negative backwards.
     * @property isBackward whether the line says `backward`, so that its number is the way back.
     */
    data class Way(
        override val pose: Pose,
        override val text: String,
        val centimetres: Double,
        val isBackward: Boolean,
    ) : SheetPreview

    /**
     * The robot turns on the spot.
     *
     * @property degrees the angle, counter-clockwise.
     * @property isRight whether the line says `right`, so that its number is the angle clockwise.
     */
    data class Turn(override val pose: Pose, override val text: String, val degrees: Double, val isRight: Boolean) :
        SheetPreview
}

/** What the number does whose sheet is open, if the robot stands at [pose]; null if it is no plain length or angle. */
fun BlocksState.sheetPreview(pose: Pose): SheetPreview? {
    val open = sheet as? BlockDialog.Part ?: return null
    val part = program.partAt(open.span) as? PhrasePart.Value ?: return null
    return previewOf(part, program.text, program.lineAt(open.span.start), pose, program.vocabulary)
}

/** The same for the number [part] of [line] in the text [source], in the words of [vocabulary]. */
fun previewOf(
    part: PhrasePart.Value,
    source: String,
    line: OutlineLine,
    pose: Pose,
    vocabulary: Vocabulary,
): SheetPreview? {
    val text = part.span.textIn(source)
    val number = text.takeIf { NUMBER.matches(it) }?.toDoubleOrNull() ?: return null
    val isReverse = line.parts.any {
        it is PhrasePart.Choice &&
            vocabulary.inEnglish(it.span.textIn(source)).lowercase() in REVERSE
    }
    val signed = if (isReverse) -number else number
    return when {
        part.use == ValueUse.DISTANCE && line.form == LineForm.MOVE -> SheetPreview.Way(pose, text, signed, isReverse)
        part.use == ValueUse.ANGLE && line.form == LineForm.TURN -> SheetPreview.Turn(pose, text, signed, isReverse)
        else -> null
    }
}

/** The number to write so that a way ends [centimetres] ahead of the robot: whole centimetres. */
fun SheetPreview.Way.numberFor(centimetres: Double): Int =
    round(if (isBackward) -centimetres else centimetres).coerceIn(0.0, MAX_CENTIMETRES).toInt()

/** The number to write so that the robot turns by [degrees] counter-clockwise: steps of five, less than a full turn. */
fun SheetPreview.Turn.numberFor(degrees: Double): Int {
    val steps = round((if (isRight) -degrees else degrees) / STEP_DEGREES) * STEP_DEGREES
    return ((steps % FULL + FULL) % FULL).toInt()
}

private val NUMBER = Regex("-?\\d+(\\.\\d+)?")

/** The words of a line by which its number counts the other way. */
private val REVERSE = setOf("backward", "right")

/** The longest way of the number's slider. */
private val MAX_CENTIMETRES = checkNotNull(ValueUse.DISTANCE.scale).max
private const val STEP_DEGREES = 5.0
private const val FULL = 360.0
