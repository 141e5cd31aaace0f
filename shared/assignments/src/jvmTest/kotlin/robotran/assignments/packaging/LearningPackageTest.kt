package robotran.assignments.packaging

import kotlinx.coroutines.runBlocking
import org.w3c.dom.Document
import robotran.language.Language
import robotran.projects.Assignment
import robotran.projects.Project
import robotran.world.file.BuiltInWorlds
import java.io.ByteArrayInputStream
import java.util.zip.ZipInputStream
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class LearningPackageTest {
    private val site = listOf(
        SiteFile("index.html", "<p>Robotran</p>".encodeToByteArray()),
        SiteFile("files/app.0123.wasm", ByteArray(50_000) { (it % 7).toByte() }),
    )

    private fun assignment(title: String) =
        Project(BuiltInWorlds.plain.copy(title = title), assignment = Assignment("id-$title".filter { it != ' ' }))

    private fun made(version: ScormVersion, vararg titles: String): Map<String, ByteArray> = runBlocking {
        val result = learningPackage("A & <B>", titles.map(::assignment), version, site, Language.ENGLISH)
        val zip = ZipInputStream(ByteArrayInputStream(assertIs<PackageResult.Made>(result).bytes))
        generateSequence { zip.nextEntry }.associate { it.name to zip.readBytes() }
    }

    private fun manifest(files: Map<String, ByteArray>): Document = DocumentBuilderFactory.newInstance()
        .apply { isNamespaceAware = true }
        .newDocumentBuilder()
        .parse(ByteArrayInputStream(files.getValue("imsmanifest.xml")))

    private fun texts(document: Document, name: String): List<String> =
        document.getElementsByTagNameNS("*", name).let { nodes ->
            (0 until nodes.length).map { nodes.item(it).textContent }
        }

    @Test
    fun `a package holds the site, the wrapper and a manifest that lists them all`() {
        val files = made(ScormVersion.SCORM_1_2, "Maze")
        for (file in site) assertContentEquals(file.bytes, files["site/${file.path}"])
        val hrefs = manifest(files).getElementsByTagNameNS("*", "file").let { nodes ->
            (0 until nodes.length).map { nodes.item(it).attributes.getNamedItem("href").nodeValue }
        }
        assertEquals(files.keys - "imsmanifest.xml", hrefs.toSet())
        assertTrue("start.html" in files && "scorm.js" in files)
    }

    @Test
    fun `each assignment is an item of its own with its title`() {
        val files = made(ScormVersion.SCORM_2004, "Maze", "Line & <loop>")
        val document = manifest(files)
        assertEquals(listOf("A & <B>", "Maze", "Line & <loop>"), texts(document, "title"))
        assertEquals(listOf("2004 4th Edition"), texts(document, "schemaversion"))
        val items = document.getElementsByTagNameNS("*", "item")
        val parameters = (0 until items.length).map { items.item(it).attributes.getNamedItem("parameters").nodeValue }
        assertEquals(listOf("?assignment=0", "?assignment=1"), parameters)
        val links = files.getValue("assignments.js").decodeToString()
        assertEquals(2, Regex("\"#p=a[A-Za-z0-9_-]+\"").findAll(links).count(), links)
    }

    @Test
    fun `the two standards have their own words`() {
        val older = files(ScormVersion.SCORM_1_2)
        val newer = files(ScormVersion.SCORM_2004)
        assertTrue("adlcp:scormtype=\"sco\"" in older && "<schemaversion>1.2<" in older, older)
        assertTrue("adlcp:scormType=\"sco\"" in newer, newer)
    }

    private fun files(version: ScormVersion) = made(version, "Maze").getValue("imsmanifest.xml").decodeToString()
}
