package robotran.ui.poster

import org.w3c.dom.Document
import org.w3c.dom.Element
import org.xml.sax.InputSource
import robotran.blockediting.blocksOf
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.BlockGroup
import robotran.simulation.state.Ink
import robotran.simulation.state.InkStroke
import robotran.ui.code.BlockLooks
import robotran.ui.sheet.SheetScenes
import robotran.ui.sheet.svg.hex
import robotran.uikit.*
import robotran.workshop.state.Poster
import robotran.world.Paper
import robotran.world.geometry.Point
import java.io.StringReader
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.math.round
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class PosterTest {
    private val poster = posterOf("pen down\nrepeat 4 times\n  forward 20 # cm\n  turn left 90\nend")

    @Test
    fun `a short program stands in large letters below the drawing`() {
        val page = layPoster(poster)
        assertFalse(page.isLandscape)
        assertEquals(
            listOf(
                "Stars",
                "Ada · 24 November",
                "pen down",
                "repeat 4 times",
                "  forward 20 # cm",
                "  turn left 90",
                "end",
            ),
            page.lines.map { it.text },
        )
        val code = page.lines.filter { it.isCode }
        assertTrue(code.all { it.size == 7.0 && it.baseline > page.sheet.top + page.sheet.height })
        assertTrue(code.flatMap { it.runs }.map { it.colour }.toSet().size > 2, "in colours")
    }

    @Test
    fun `letters are only large where every line has its room in one column`() {
        val wide = layPoster(posterOf("beep\nshow \"a sentence that would not fit in one line of large letters\""))
        val long = layPoster(posterOf(List(16) { "beep" }.joinToString("\n")))
        val few = layPoster(posterOf(List(9) { "beep" }.joinToString("\n")))
        for (page in listOf(wide, long, few)) {
            val code = page.lines.filter { it.isCode }
            val isInOneColumn = code.map { it.left }.distinct().size == 1
            assertTrue(code.first().size <= 4.2 || isInOneColumn, "${code.first().size}")
        }
        assertEquals(2, wide.lines.count { it.isCode })
        assertEquals(7.0, few.lines.first { it.isCode }.size)
        assertTrue(long.lines.first { it.isCode }.size in 4.2..7.0)
    }

    @Test
    fun `nothing leaves the page or covers something else, whatever the program and the paper are`() {
        val lengths = listOf(0, 1, 20, 60, 150, 400, 2_000)
        val papers = listOf(Paper(100.0, 80.0), Paper(200.0, 40.0), Paper(40.0, 200.0))
        for (paper in papers) {
            for (count in lengths) {
                for (line in listOf(
                    "beep",
                    "  show \"a long sentence with many words that goes on and on and on\" + 12345678",
                )) {
                    val page = layPoster(posterOf(List(count) { line }.joinToString("\n"), paper))
                    assertEquals(emptyList(), page.errors(), "$count lines on $paper")
                }
            }
        }
    }

    @Test
    fun `a program that is too long says how many lines are missing, in the pupil's language`() {
        val lines = 1_000
        val german = posterOf(List(lines) { "beep" }.joinToString("\n")).copy(language = Language.GERMAN)
        val code = layPoster(german).lines.filter { it.isCode }
        assertEquals("… und ${lines - code.size + 1} weitere Zeilen", code.last().text)
        assertTrue(code.size > 100)
    }

    @Test
    fun `long lines go on below, a little to the right`() {
        val runs = listOf(PosterRun("  show ", TITLE_COLOUR), PosterRun("abcdefghijklmnop", QUIET_COLOUR))
        assertEquals(
            listOf("  show abc", "     defgh", "     ijklm", "     nop"),
            wrapped(runs, columns = 10).map { line -> line.joinToString("") { it.words } },
        )
    }

    @Test
    fun `several files have their names between them`() {
        val program = Program.of(listOf(SourceFile("A.java", "class A {}"), SourceFile("B.java", "class B {}")))
        assertEquals(
            listOf("// A.java", "class A {}", "", "// B.java", "class B {}"),
            codeLines(program).map { line -> line.joinToString("") { it.words } },
        )
    }

    @Test
    fun `the page as SVG is XML of the size of A4 with all its words`() {
        val svg = posterSvg(poster.copy(title = "<Tom> & \"Ann\""))
        val document = read(svg)
        assertEquals("210mm", document.documentElement.getAttribute("width"))
        assertEquals("297mm", document.documentElement.getAttribute("height"))
        val words = document.elements("text").map { it.textContent.replace('\u00A0', ' ') }
        assertTrue("<Tom> & \"Ann\"" in words && "  forward 20 # cm" in words, "$words")
        assertEquals(2, document.elements("svg").size)
    }

    @Test
    fun `the drawing with a margin fills its place, and the paper is never left`() {
        val line = listOf(Point(20.0, 30.0), Point(40.0, 60.0))
        val session = SheetScenes.everythingLater.copy(ink = Ink(listOf(InkStroke(line)), 36.0), robots = emptyList())
        val crop = cropOf(SheetScenes.everything, session, aspect = 1.0)
        assertEquals(listOf(34.8, 34.8), listOf(crop.width, crop.height).map { round(it * 10) / 10 })
        assertEquals(listOf(12.6, 27.6), listOf(crop.left, crop.top).map { round(it * 10) / 10 })
        val atEdge = session.copy(ink = Ink(listOf(InkStroke(listOf(Point(0.0, 0.0), Point(119.0, 1.0)))), 119.0))
        assertEquals(PosterArea(0.0, 0.0, 120.0, 90.0), cropOf(SheetScenes.everything, atEdge, aspect = 1.0))
        val empty = session.copy(ink = Ink.NONE)
        assertEquals(PosterArea(0.0, 0.0, 120.0, 90.0), cropOf(SheetScenes.everything, empty, aspect = 1.0))
    }

    @Test
    fun `a small drawing takes more than half of the page's width and height beside the margins`() {
        val ink = Ink(listOf(InkStroke(listOf(Point(60.0, 50.0), Point(80.0, 50.0), Point(80.0, 70.0)))), 40.0)
        val small = poster.copy(session = SheetScenes.everythingLater.copy(ink = ink, robots = emptyList()))
        val page = layPoster(small)
        assertTrue(page.sheet.width * page.sheet.height > 0.5 * 186 * 252, "${page.sheet}")
        assertTrue(page.crop.width < 40)
    }

    @Test
    fun `a program built with blocks is printed as blocks`() {
        val text = "pen down // now it draws\nrepeat 4 times\n  forward 20\n  turn left 90 degrees\nend"
        val page = layPoster(posterOf(text).inBlocks())
        val words = page.lines.filter { it.isCode }.map { it.text }
        assertEquals(
            listOf("pen", "down", "now it draws", "repeat", "4", "times", "forward", "20 cm", "turn", "left", "90"),
            words.take(11),
        )
        assertEquals("end", words.last())
        val groups = page.boxes.map { it.fill }.toSet()
        assertTrue(groups.containsAll(listOf(BlockGroup.PEN, BlockGroup.DRIVE, BlockGroup.CONTROL).map(::fillOf)))
        assertTrue("fill=\"${hex(fillOf(BlockGroup.DRIVE))}\"" in posterSvg(posterOf(text).inBlocks()))
    }

    @Test
    fun `a value that is wider than its column goes on below, between its words`() {
        val piece = PosterPiece("left bumper or right bumper", isSocket = true)
        assertEquals(listOf("left bumper or", "right bumper"), piece.cut(room = 12.0).map { it.text })
        assertEquals(listOf("abcdefgh", "ij"), PosterPiece("abcdefghij", isSocket = false).cut(5.0).map { it.text })
    }

    @Test
    fun `no block leaves the page, and those without room are counted`() {
        for (count in listOf(1, 20, 60, 400)) {
            val text = List(count) { "if left bumper or right bumper\n  show 1 + 2 + 3 + 4 + 5 + 6 + 7 + 8\nend" }
            val page = layPoster(posterOf(text.joinToString("\n")).inBlocks())
            assertEquals(emptyList(), page.errors(), "$count blocks")
            val outside = page.boxes.filter { (area) ->
                area.left < 11.9 || area.left + area.width > page.width - 11.9 ||
                    area.top + area.height > page.height - 11
            }
            assertEquals(emptyList(), outside, "$count blocks")
            assertEquals(count > 20, page.lines.last().text.startsWith("… and "), "$count blocks")
        }
    }

    private fun PosterPage.errors(): List<String> {
        val areas = lines.map { line ->
            val width = if (line.isCode) {
                line.text.length * line.size * CODE_ADVANCE
            } else {
                line.text.length * line.size *
                    0.6
            }
            line.text to listOf(line.left, line.baseline - line.size, line.left + width, line.baseline)
        } + ("sheet" to listOf(sheet.left, sheet.top, sheet.left + sheet.width, sheet.top + sheet.height))
        val outside = areas.filter { (_, box) ->
            box[0] < 11.9 || box[1] < 5 || box[2] > width - 11.9 || box[3] > height - 5
        }.map { "${it.first} is outside at ${it.second}" }
        val sheetBox = areas.last().second
        val covering = areas.dropLast(1).filter { (_, box) ->
            box[0] < sheetBox[2] && box[2] > sheetBox[0] && box[1] < sheetBox[3] && box[3] > sheetBox[1]
        }.map { "${it.first} covers the sheet" }
        return outside + covering
    }

    private fun posterOf(text: String, paper: Paper = SheetScenes.everything.paper) = Poster(
        title = "Stars",
        maker = "Ada",
        date = "24 November",
        world = SheetScenes.everything.copy(paper = paper),
        session = SheetScenes.everythingLater,
        program = Program.of("stars.robo", text),
        language = Language.ENGLISH,
    )

    private fun Poster.inBlocks() =
        copy(blocks = blocksOf(program.files.single().text, RobolangMessages.of(Language.ENGLISH)))

    private fun fillOf(group: BlockGroup) = BlockLooks(RobotranColours.LIGHT).of(group).fill

    private fun read(svg: String): Document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(InputSource(StringReader(svg)))

    private fun Document.elements(name: String): List<Element> =
        getElementsByTagName(name).let { all -> List(all.length) { all.item(it) as Element } }
}
