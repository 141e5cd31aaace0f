package robotran.ui.export

import androidx.compose.ui.text.font.createFontFamilyResolver
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.projects.ProgramView
import robotran.ui.golden.GoldenPicture
import robotran.ui.pictures.DrawnWorldPictures
import robotran.ui.poster.posterPng
import robotran.ui.poster.posterSvg
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import robotran.workshop.platform.FileKind
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.NoVideoRecorder
import robotran.workshop.platform.Posters
import robotran.workshop.platform.Printing
import robotran.workshop.platform.VideoRecorder
import robotran.workshop.state.AppTheme
import robotran.workshop.state.MovingKind
import robotran.workshop.state.Poster
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Pictures of the sheet with which pupils show what they made, for review. */
class ExportPictures {
    @Test
    fun `every step on all screens, dark, in German and with text twice as large`() {
        for (screen in Screen.entries) {
            for ((look, settings) in LOOKS) {
                for ((step, prepare) in STEPS) {
                    picture(screen, settings, prepare).keepAs("show/${screen.name.lowercase()}-$look-$step")
                }
            }
        }
    }
}

/** The sheet with which pupils show what they made, compared with references. */
class ExportPicturesTest {
    @Test
    fun `the choice, the poster and what was made look as they did`() {
        for (screen in Screen.entries) {
            for ((look, settings) in LOOKS.filterKeys { it == "light" || it == "dark" }) {
                for ((step, prepare) in STEPS.filterKeys { it in GOLDEN }) {
                    val name = "show-$step-${screen.name.lowercase()}-$look"
                    GoldenPicture.check(name, picture(screen, settings, prepare))
                }
            }
        }
    }
}

private fun picture(screen: Screen, settings: Settings, prepare: Workshop.() -> Unit) = onWorkshop { workshop ->
    workshop.handle(SettingsEvent.SettingsChanged(settings))
    workshop.handle(RunEvent.RunPressed)
    workshop.advance(HALF_DRAWN)
    workshop.handle(ExportEvent.Requested)
    workshop.prepare()
    photograph(workshop, screen.width, screen.height)
}

private fun <T> onWorkshop(use: (Workshop) -> T): T {
    val platform = MemoryPlatform(pictures = DrawnWorldPictures(), videos = AnyCamera, posters = AnyPrinter)
    val workshop = runBlocking { openWorkshop(platform = platform) }
    try {
        return use(workshop)
    } finally {
        workshop.close()
    }
}

private object AnyCamera : VideoRecorder by NoVideoRecorder {
    override val isAvailable: Boolean get() = true
}

private object AnyPrinter : Posters {
    override val canPrint: Boolean get() = true

    override fun svg(poster: Poster): String = posterSvg(poster)

    override suspend fun png(poster: Poster): ByteArray = posterPng(poster, createFontFamilyResolver())

    override suspend fun print(poster: Poster): Printing = Printing.Cancelled
}

private enum class Screen(val width: Int, val height: Int) {
    PHONE(411, 891),
    PHONE_ACROSS(891, 411),
    TABLET(1280, 800),
    LAPTOP(1440, 900),
}

/** Milliseconds into the square program: somewhere on its third side. */
private const val HALF_DRAWN = 3_900

private val LOOKS = mapOf(
    "light" to Settings(lessMotion = true),
    "dark" to Settings(lessMotion = true, theme = AppTheme.DARK),
    "german" to Settings(lessMotion = true, language = Language.GERMAN),
    "200" to Settings(lessMotion = true, textScale = 2f),
)

private val GOLDEN = setOf("choice", "poster", "made-poster")

private val STEPS: Map<String, Workshop.() -> Unit> = mapOf(
    "choice" to {},
    "speed" to { handle(ExportEvent.MovingChosen(MovingKind.VIDEO)) },
    "poster" to {
        handle(ExportEvent.PosterChosen)
        handle(ExportEvent.PosterChanged("My square", "Ada", isDated = true))
    },
    "made-picture" to { handle(ExportEvent.StillChosen(FileKind.PNG)) },
    "made-poster" to {
        handle(ExportEvent.Closed)
        handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        handle(ExportEvent.Requested)
        handle(ExportEvent.PosterChosen)
        handle(ExportEvent.PosterChanged("My square", "Ada", isDated = true))
        handle(ExportEvent.MakingRequested)
    },
)
