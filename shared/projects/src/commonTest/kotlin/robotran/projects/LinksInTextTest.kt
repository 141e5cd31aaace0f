package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import kotlin.io.encoding.Base64
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class LinksInTextTest {
    private suspend fun fragment(): String =
        assertIs<LinkCreation.Made>(linkOf(FULL_PROJECT, Language.ENGLISH)).fragment

    private suspend fun address(): String = "https://school.example/robotran/" + fragment()

    private fun percent(address: String) = address.replace(":", "%3A").replace("/", "%2F").replace("#", "%23")
        .replace("=", "%3D")

    private suspend fun assertFound(mail: String) {
        assertEquals(listOf(fragment()), linksIn(mail).map { it.link }, mail)
        assertTrue(isLink(mail), mail)
        assertIs<LinkResult.OfProject>(openLink(mail, Language.ENGLISH), mail)
    }

    /** As mail programs wrap a text that is not encoded. */
    private fun wrapped(text: String, width: Int, quoting: String = "", end: String = "\r\n") =
        text.chunked(width).joinToString(end) { quoting + it }

    private fun quotedPrintable(text: String): String {
        val escaped = text.replace("=", "=3D")
        val lines = mutableListOf<String>()
        var rest = escaped
        while (rest.length > 75) {
            // No escape is torn apart.
            val cut = (75 downTo 73).first { rest[it - 1] != '=' && rest[it - 2] != '=' }
            lines += rest.take(cut) + "="
            rest = rest.drop(cut)
        }
        return (lines + rest).joinToString("\r\n")
    }

    @Test
    fun `a link that a mail program has wrapped is read whole`() = runTest {
        for (width in listOf(60, 72, 76, 78, 120)) {
            for (quoting in listOf("", "> ", ">> ")) {
                for (end in listOf("\n", "\r\n")) {
                    val link = wrapped(address(), width, quoting, end)
                    assertFound("Hello,\n\n$link\n\nBest regards\nAnna")
                    assertFound("$link${end}Anna")
                }
            }
        }
    }

    @Test
    fun `a link is read whole wherever its first characters are wrapped`() = runTest {
        for (before in 60..76) assertFound(wrapped("x".repeat(before) + " " + fragment(), 76))
    }

    @Test
    fun `the last line of a wrapped link may be as long as the others`() = runTest {
        val link = fragment()
        for (word in listOf("Thanks", "Anna", "Best regards")) {
            val padding = "x".repeat(76 - (link.length + 1) % 76) + " "
            assertFound(wrapped(padding + link, 76) + "\n$word\n")
        }
    }

    @Test
    fun `a mail in quoted-printable is read`() = runTest {
        for (before in 0..90) {
            val text = "x".repeat(before) + " <" + address() + ">"
            assertFound("Content-Transfer-Encoding: quoted-printable\r\n\r\n" + quotedPrintable(text))
        }
    }

    @Test
    fun `a mail in Base64 is read`() = runTest {
        val body = Base64.Mime.encode("Hallo, \u00FC\n${address()}\nAnna\n".encodeToByteArray())
        assertFound(
            "Subject: maze\r\nContent-Transfer-Encoding: base64\r\nContent-Type: text/plain; charset=utf-8\r\n\r\n" +
                "$body\r\n\r\n--end--\r\n",
        )
    }

    @Test
    fun `a link that a mail filter has rewritten is read`() = runTest {
        val address = address()
        val once = percent(address)
        val twice = once.replace("%", "%25")
        val dashed = address.replace("-", "-2D").replace("_", "-5F").replace("/", "_")
            .replaceFirst("#", "-23").replaceFirst("=", "-3D").replaceFirst(":", "-3A")
        val mails = listOf(
            "https://eur01.safelinks.protection.outlook.com/?url=$once&data=05%7C02%7C&sdata=abc%3D&reserved=0",
            "https://eur01.safelinks.protection.outlook.com/?url=$once&amp;data=05%7C02",
            "https://filter.example/?a=$twice&c=E,1",
            "https://filter.example/?a=${once.lowercase().substringBefore("%23")}%23p%3d${once.substringAfter("%3D")}",
            "https://urldefense.proofpoint.com/v2/url?u=$dashed&d=DwMFaQ&c=x",
            "https://urldefense.com/v3/__${address.replaceFirst("#", "*")}__;Iw!!abc!def\$ ",
        )
        for (mail in mails) {
            assertFound("Look:\n$mail\nAnna")
            assertFound(quotedPrintable("Look: $mail"))
        }
        for (width in listOf(72, 76)) assertFound("Look:\n" + wrapped(mails.first(), width) + "\nAnna")
    }

    @Test
    fun `every link of a mail is found with its line`() = runTest {
        val link = fragment()
        val text = "One:\n$link\n\nTwo:\n" + wrapped(address(), 76, end = "\n") + "\nThree: #w=aQ, four: #c=aR.\n"
        val third = 5 + address().chunked(76).size
        assertEquals(
            listOf(FoundLink(2, link), FoundLink(5, link), FoundLink(third, "#w=aQ"), FoundLink(third, "#c=aR")),
            linksIn(text),
        )
        val printable = "A link:=20\r\n" + quotedPrintable(address()) + "\r\nand #w=3DaQ"
        assertEquals(listOf(2, 2 + quotedPrintable(address()).lines().size), linksIn(printable).map { it.line })
    }

    @Test
    fun `other texts and file names are no links`() = runTest {
        val names = listOf("maze.robotran", "a#b.robo", "C#p.java", "100%23.robo", "x-23w-3Dy.robo", "*w=a.robo")
        for (name in names) assertFalse(isLink(name), name)
    }

    @Test
    fun `any text is read to its end, with a limit for what is found`() = runTest {
        val random = Random(76)
        val parts = listOf(
            "#",
            "w",
            "p",
            "=",
            "3D",
            "%23",
            "%25",
            "%3D",
            "-23",
            "-3D",
            "*",
            "urldefense",
            "__;",
            "=\r\n",
            "\n",
            "\r\n",
            "> ",
            " ",
            "a",
            "Zz09-_",
            "%2D",
            "-5F",
            "Content-Transfer-Encoding: base64\n\n",
            "#p=a",
            "\u00FC",
        )
        repeat(3_000) {
            val text = List(random.nextInt(60)) { parts.random(random) }.joinToString("")
            for (found in linksIn(text)) {
                assertTrue(Regex("#[wpch]=[A-Za-z0-9_-]+").matches(found.link), found.link)
                assertTrue(found.line in 1..text.count { it == '\n' } + 1, "$found in $text")
                openLink(found.link, Language.ENGLISH)
            }
        }
        assertEquals(ProjectLimits.MAXIMUM_LINKS, linksIn("#w=a ".repeat(100_000)).size)
        assertEquals(1, linksIn("#w=a" + wrapped("b".repeat(900_000), 76)).size)
        linksIn("Content-Transfer-Encoding: base64\n\n" + "QUJD\n".repeat(200_000))
        linksIn("Content-Transfer-Encoding: base64\n\n".repeat(20_000))
    }
}
