package robotran.build.site

import java.io.File
import kotlin.io.path.createTempDirectory
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals

class SiteFileTest {
    private val folder = createTempDirectory("robotran").toFile()

    @AfterTest
    fun tidyUp() {
        folder.deleteRecursively()
    }

    private fun file(name: String, text: String): File = folder.resolve(name).apply { writeText(text) }

    @Test
    fun `a file gets the beginning of its SHA-256 into its name`() {
        assertEquals("files/page.ba7816bf8f01cfea.js", SiteFile.of(file("page.js", "abc")).address)
        assertEquals("strings.commonMain.ba7816bf8f01cfea.cvr", SiteFile.of(file("strings.commonMain.cvr", "abc")).name)
    }

    @Test
    fun `a name that says what is in the file stays as it is, since scripts know it`() {
        assertEquals("ecj.0057ad2dfc5f5068.wasm", SiteFile.of(file("ecj.0057ad2dfc5f5068.wasm", "abc")).name)
    }

    @Test
    fun `a browser's way to write a SHA-256`() {
        assertEquals("sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0=", integrityOf("abc".toByteArray()))
    }

    @Test
    fun `JSON that stands in a page cannot end its script`() {
        assertEquals(
            """{"a \"quoted\" name":["\u003c/script>",7,"\\"]}""",
            json(mapOf("a \"quoted\" name" to listOf("</script>", 7, "\\"))),
        )
    }

    @Test
    fun `the policy names the page's one script and one style and nothing that is unsafe but WebAssembly`() {
        val policy = policyFor("abc", "abc")
        assertEquals(2, policy.split("'sha256-ungWv48Bz+pBQUDeXa4iI7ADYaOWF3qctBD/YfIAFa0='").size - 1)
        assertEquals(
            listOf("wasm-unsafe-eval"),
            Regex("[\\w-]*unsafe[\\w-]*").findAll(policy).map { it.value }.toList(),
        )
    }
}
