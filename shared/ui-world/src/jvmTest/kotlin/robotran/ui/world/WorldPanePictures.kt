package robotran.ui.world

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.drawscope.CanvasDrawScope
import androidx.compose.ui.graphics.drawscope.translate
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.LayoutDirection
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.ui.pictures.pngOf
import robotran.ui.screen.keepAs
import robotran.ui.screen.photograph
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.renderSheet
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Settings
import robotran.workshop.state.SheetCamera
import robotran.workshop.state.SheetElement
import robotran.workshop.state.SheetElementKind
import robotran.workshop.state.SheetLayer
import robotran.workshop.state.SheetWords
import robotran.world.World
import robotran.world.file.WorldFileResult
import robotran.world.file.readWorld
import robotran.world.geometry.Point
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Pictures of the world pane for review, in `build/pictures/world`. */
class WorldPanePictures {
    private val folder = File("build/pictures/world").apply { mkdirs() }
    private val physics = runBlocking { loadPhysicsEngine() }
    private val lightRoom = world("light-room")

    @Test
    fun `the pane can be photographed large and small, by day and by night, from near and far`() {
        photograph(
            "tablet",
            handyWorld,
            1280,
            800,
            dark = false,
            shown(SheetLayer.SENSORS, SheetLayer.GRID) + chosen(0),
        )
        photograph(
            "tablet-dark",
            handyWorld,
            1280,
            800,
            dark = true,
            shown(SheetLayer.SENSORS, SheetLayer.TRAIL, SheetLayer.NAMES),
        )
        photograph("phone", handyWorld, 411, 891, dark = false, chosen(0))
        val near = SheetEvent.CameraMoved(SheetCamera(6.0, Point(45.0, 42.0)), pushed = true)
        photograph(
            "laptop-near",
            handyWorld,
            1440,
            900,
            dark = false,
            shown(SheetLayer.SENSORS, SheetLayer.GRID, SheetLayer.TRAIL) + near,
        )
        photograph("laptop-light-room", lightRoom, 1440, 900, dark = false, shown(SheetLayer.SENSORS))
        photograph(
            "phone-german-large",
            handyWorld,
            411,
            891,
            dark = false,
            chosen(0),
            Settings(Language.GERMAN, textScale = 2f),
        )
    }

    @Test
    fun `what is told above the sheet`() {
        val tells = Settings(tellsRuns = true)
        val explored = listOf(SheetEvent.WordsChanged(SheetWords.Explored(Point(60.0, 31.0))))
        photograph("words-tablet", handyWorld, 1280, 800, dark = false, listOf(RunEvent.StoryRequested), tells)
        photograph("words-explored", handyWorld, 1280, 800, dark = true, explored, tells)
        photograph("words-phone", handyWorld, 411, 891, dark = false, listOf(RunEvent.StoryRequested), tells)
        val large = tells.copy(language = Language.GERMAN, textScale = 2f)
        photograph("words-phone-german-large", handyWorld, 411, 891, dark = false, explored, large)
        val french = tells.copy(language = Language.FRENCH)
        photograph("words-french", handyWorld, 411, 891, dark = false, listOf(RunEvent.StoryRequested), french)
    }

    @Test
    fun `all worlds on one sheet, by day and by night`() {
        val worlds = File("../../worlds").listFiles { file ->
            file.name.endsWith(".world.json")
        }.orEmpty().sortedBy { it.name }
        assertTrue(worlds.size >= 20, "only ${worlds.size} worlds")
        for ((name, colours) in listOf(
            "light" to SheetColours.LIGHT,
            "dark" to SheetColours.of(RobotranColours.DARK),
        )) {
            val sheets = worlds.map { file ->
                val world = world(file.name.removeSuffix(".world.json"))
                val session =
                    Session(world, emptyList<robotran.simulation.RobotProgramSet>(), physics, Language.ENGLISH)
                renderSheet(world, session.state, TILE, colours = colours).also { session.close() }
            }
            val contact = contactSheet(sheets)
            File(folder, "worlds-$name.png").writeBytes(pngOf(contact))
            assertEquals(COLUMNS * TILE, contact.width)
        }
    }

    private fun contactSheet(sheets: List<ImageBitmap>): ImageBitmap {
        val rows = (sheets.size + COLUMNS - 1) / COLUMNS
        val image = ImageBitmap(COLUMNS * TILE, rows * TILE)
        CanvasDrawScope().draw(
            Density(1f),
            LayoutDirection.Ltr,
            Canvas(image),
            Size(image.width.toFloat(), image.height.toFloat()),
        ) {
            sheets.forEachIndexed { number, sheet ->
                translate((number % COLUMNS * TILE).toFloat(), (number / COLUMNS * TILE).toFloat()) {
                    drawImage(sheet, Offset.Zero)
                }
            }
        }
        return image
    }

    private fun photograph(
        name: String,
        world: World,
        width: Int,
        height: Int,
        dark: Boolean,
        events: List<WorkshopEvent>,
        settings: Settings = Settings(),
    ) {
        val workshop = Workshop(Project(world), physics, settings = settings)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(RUN_MILLISECONDS)
        events.forEach(workshop::handle)
        photograph(workshop, width, height, dark).keepAs("world/$name")
        workshop.close()
    }

    private fun shown(vararg layers: SheetLayer): List<WorkshopEvent> = layers.map {
        SheetEvent.LayerSwitched(it, true)
    }

    private fun chosen(robot: Int): List<WorkshopEvent> =
        listOf(SheetEvent.ElementChosen(SheetElement(SheetElementKind.ROBOT, robot)))

    private fun world(name: String): World =
        (readWorld(File("../../worlds/$name.world.json").readText(), Language.ENGLISH) as WorldFileResult.Success).world

    private companion object {
        const val RUN_MILLISECONDS = 3_200
        const val TILE = 400
        const val COLUMNS = 5
    }
}
