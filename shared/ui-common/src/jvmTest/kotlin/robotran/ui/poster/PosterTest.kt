package robotran.ui.poster

import org.w3c.dom.Document
import org.w3c.dom.Element
import org.xml.sax.InputSource
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.ui.sheet.SheetScenes
import robotran.workshop.state.Poster
import robotran.world.Paper
import java.io.StringReader
import javax.xml.parsers.DocumentBuilderFactory
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
        assertTrue(code.all { it.size == 4.2 && it.baseline > page.sheet.top + page.sheet.height })
        assertTrue(code.flatMap { it.runs }.map { it.colour }.toSet().size > 2, "in colours")
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
        assertEquals(1, document.elements("svg").count { it.getAttribute("viewBox") == "0 0 120 90" })
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

    private fun read(svg: String): Document =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(InputSource(StringReader(svg)))

    private fun Document.elements(name: String): List<Element> =
        getElementsByTagName(name).let { all -> List(all.length) { all.item(it) as Element } }
}
