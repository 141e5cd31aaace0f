package robotran.benchmarks

import androidx.compose.ui.ImageComposeScene
import androidx.compose.ui.InternalComposeUiApi
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.PointerButton
import androidx.compose.ui.input.pointer.PointerButtons
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.unit.Density
import org.jetbrains.skiko.MainUIDispatcher
import robotran.projects.ProgramView
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.ui.RobotranApp
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.openWorkshop
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.measureTime

/**
 * The time of a frame while the mouse carries a block over a program of some 500 blocks, all over the list and into its
 * edges, where it scrolls.
 */
internal suspend fun blockDragTime(): Measurement = onScreen(DRAGGED_GROUPS, ProgramView.BLOCKS) { screen ->
    screen.mouse(PointerEventType.Move, FIRST_BLOCK)
    screen.mouse(PointerEventType.Press, FIRST_BLOCK)
    val times = screen.times { frame ->
        val down = frame % TURN / TURN.toFloat()
        mouse(PointerEventType.Move, Offset(PROGRAM.x, TOP + (HIGH - TOP) * down))
    }
    screen.mouse(PointerEventType.Release, PROGRAM)
    check(screen.workshop.state.programs.blocks?.said != null) { "Nothing was carried." }
    figureOf(times, "${DRAGGED_GROUPS * BLOCKS} blocks")
}

/** The time of a frame while the wheel scrolls through 2,000 lines that are shown in [view]. */
internal suspend fun scrollTime(view: ProgramView): Measurement = onScreen(SCROLLED_GROUPS, view) { screen ->
    screen.mouse(PointerEventType.Move, PROGRAM)
    val before = screen.picture()
    val times = screen.times { mouse(PointerEventType.Scroll, PROGRAM, Offset(0f, SCROLL)) }
    check(!screen.picture().contentEquals(before)) { "Nothing has scrolled." }
    figureOf(times, "${SCROLLED_GROUPS * NESTED.size} lines")
}

private fun figureOf(times: List<Duration>, what: String): Measurement {
    val sorted = times.sorted().map { it.toDouble(DurationUnit.MILLISECONDS) }
    val worst = rounded(sorted[sorted.size * 99 / 100])
    val note = "99th percentile $worst ms; $what, software rendering, 1280 by 800"
    return Measurement(sorted[sorted.size / 2], "ms a frame, the median", note)
}

/** A tablet's screen without a display. */
private class Screen(val workshop: Workshop) {
    private val scene =
        ImageComposeScene(WIDE, HIGH, Density(1f), MainUIDispatcher) { RobotranApp(workshop, dark = false) }
    private var now = 0L
    private var isDown = false

    fun close() {
        scene.close()
        workshop.close()
    }

    fun frame() {
        now += FRAME_STEP
        scene.render(now).close()
    }

    fun picture(): ByteArray {
        now += FRAME_STEP
        return scene.render(now).use { checkNotNull(it.encodeToData()).bytes }
    }

    @OptIn(InternalComposeUiApi::class)
    fun mouse(type: PointerEventType, place: Offset, scroll: Offset = Offset.Zero) {
        if (type == PointerEventType.Press) isDown = true
        if (type == PointerEventType.Release) isDown = false
        scene.sendPointerEvent(
            type,
            place,
            scroll,
            now / NANOSECONDS,
            PointerType.Mouse,
            buttons = PointerButtons(isPrimaryPressed = isDown),
            button = PointerButton.Primary.takeIf {
                type == PointerEventType.Press || type == PointerEventType.Release
            },
        )
    }

    fun times(act: Screen.(Int) -> Unit): List<Duration> = List(WARMING + MEASURED) { frame ->
        measureTime {
            act(frame)
            frame()
        }
    }.drop(WARMING)
}

private suspend fun onScreen(groups: Int, view: ProgramView, measure: (Screen) -> Measurement): Measurement {
    val workshop: Workshop = openWorkshop()
    val text = List(groups) { NESTED }.flatten().joinToString("\n", postfix = "\n")
    workshop.handle(ProgramEvent.DraftChanged(TextDocument(text).withCaret(0), EditKind.OTHER))
    workshop.handle(BlockEvent.ViewChosen(view))
    val screen = Screen(workshop)
    repeat(SETTLING) { screen.frame() }
    return measure(screen).also { screen.close() }
}

/** Blocks of all kinds, with a loop around some, as pupils write them. */
private val NESTED = listOf(
    "forward 20",
    "repeat 4 times",
    "  turn left 90",
    "  if left bumper or right bumper",
    "    backward 5 + 2 // back off",
    "  else",
    "    play 440 for 1 second",
    "  end",
    "end",
    "pen down",
)

/** The blocks of [NESTED]: `else` and `end` are parts of others. */
private const val BLOCKS = 7
private const val DRAGGED_GROUPS = 72
private const val SCROLLED_GROUPS = 200
private const val WIDE = 1280
private const val HIGH = 800

/** Where the first block is taken up, and the middle of the program, on the screen. */
private val FIRST_BLOCK = Offset(142f, 172f)
private val PROGRAM = Offset(300f, 450f)

/** Where the program begins. */
private const val TOP = 146f
private const val SETTLING = 60
private const val FRAME_STEP = 16_666_667L
private const val NANOSECONDS = 1_000_000L

/** The frames in which the mouse goes from the upper to the lower edge of the list. */
private const val TURN = 90

/** What a turn of the wheel by one notch tells Compose. */
private const val SCROLL = 1f
private const val WARMING = 300
private const val MEASURED = 600
