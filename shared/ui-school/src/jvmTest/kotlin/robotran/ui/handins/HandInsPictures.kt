package robotran.ui.handins

import org.jetbrains.skia.Image
import robotran.language.Language
import robotran.ui.language.InLanguage
import robotran.ui.screen.keepAs
import robotran.ui.screen.onEventThread
import robotran.ui.screen.sceneOf
import robotran.ui.theme.RobotranTheme
import robotran.workshop.handins.AnyClass
import robotran.workshop.state.AppTheme
import robotran.workshop.state.GradingProgress
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState
import robotran.workshop.state.OpenedHandIn
import robotran.workshop.state.Settings
import robotran.world.Paper
import kotlin.test.Test

/** Pictures of the page on which a teacher looks at hand-ins, for review. */
class HandInsPictures {
    @Test
    fun `the table, and what is in it, on all screens and in all looks`() {
        for ((look, settings) in LOOKS) {
            val workshop = gradedClass(AnyClass.whole, settings)
            val graded = commented(checkNotNull(workshop.state.handIns))
            workshop.close()
            val steps = mapOf(
                "table" to graded,
                "by-name" to graded.copy(
                    rows = graded.rows.sortedBy { it.name },
                    order = HandInOrder.NAME,
                    message = null,
                ),
                "grading" to graded.copy(
                    rows = graded.rows.mapIndexed { index, row -> if (index < 12) row else row.copy(graded = null) },
                    progress = GradingProgress(12, 25, 0.47f, 21),
                    message = null,
                ),
                "one-partly" to opened(graded, "Dina"),
                "one-alike" to opened(graded, "Ada Lovelace", ""),
                "one-solved" to opened(graded, "Hugo"),
                "removed" to graded.copy(message = HandInsMessage.Removed("Ada Lovelace")),
                "compare" to opened(graded, "Ada Lovelace").copy(dialog = HandInsDialog.Comparing),
                "one-mistakes" to opened(graded, "Vera"),
                "empty" to
                    graded.copy(
                        rows = emptyList(),
                        kind = HandInsKind.WITHOUT_CHECKS,
                        message = HandInsMessage.NothingFound(),
                    ),
            )
            for (screen in Screen.entries) {
                if (look != "light" && screen !in FEW) continue
                for ((step, state) in steps) {
                    picture(state, screen, settings).keepAs("hand-ins/${screen.name.lowercase()}-$look-$step")
                }
            }
        }
    }

    @Test
    fun `a wide sheet, and names that are long or the same`() {
        val world = AnyClass.teachers.world.copy(paper = Paper(width = 260.0, height = 60.0))
        for ((look, settings) in LOOKS) {
            val twins = listOf("To the wide wall and back", "To the wide wall and back again").map {
                AnyClass.file(AnyClass.handIn("Ida", AnyClass.turning), "$it - Ida")
            }
            val workshop = gradedClass(AnyClass.few + twins, settings, AnyClass.teachers.copy(world = world))
            val state = checkNotNull(workshop.state.handIns)
            workshop.close()
            for (screen in Screen.entries) {
                picture(state, screen, settings).keepAs("hand-ins/${screen.name.lowercase()}-$look-wide")
            }
        }
    }

    private fun commented(state: HandInsState) = state.copy(
        rows = state.rows.mapIndexed { index, row ->
            if (index % 3 == 0) {
                row.copy(comment = "Your robot is nearly there, ${row.name}. Look at the turn.")
            } else {
                row
            }
        },
    )

    private fun opened(state: HandInsState, name: String, beside: String? = null): HandInsState {
        val id = state.rows.first { it.name == name }.id
        return state.copy(opened = OpenedHandIn(id, beside), message = null)
    }

    private fun picture(state: HandInsState, screen: Screen, settings: Settings): Image = onEventThread {
        val scene = sceneOf(screen.width, screen.height) {
            InLanguage(settings.language) {
                RobotranTheme(settings.theme == AppTheme.DARK, settings) { HandInsPage(state) { } }
            }
        }
        try {
            scene.render()
            // Pictures of sheets are drawn in the background.
            repeat(FRAMES) {
                Thread.sleep(PAUSE)
                scene.render(it * SECOND)
            }
            scene.render(FRAMES * SECOND)
        } finally {
            scene.close()
        }
    }

    private enum class Screen(val width: Int, val height: Int) {
        PHONE(360, 740),
        TABLET(1024, 768),
        TABLET_UPRIGHT(800, 1280),
        LAPTOP(1280, 800),
    }

    private companion object {
        const val SECOND = 1_000_000_000L
        const val FRAMES = 8
        const val PAUSE = 60L
        val FEW = listOf(Screen.PHONE, Screen.LAPTOP)
        val LOOKS = mapOf(
            "light" to Settings(lessMotion = true),
            "dark" to Settings(lessMotion = true, theme = AppTheme.DARK),
            "german" to Settings(lessMotion = true, language = Language.GERMAN),
            "200" to Settings(lessMotion = true, textScale = 2f),
        )
    }
}
