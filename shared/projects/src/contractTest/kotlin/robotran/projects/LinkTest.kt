package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.json.JsonLimits
import robotran.language.Language
import robotran.simulation.SessionInput
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import kotlin.io.encoding.Base64
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class LinkTest {
    private suspend fun refusal(link: String): String =
        assertIs<LinkResult.Rejected>(openLink(link, Language.ENGLISH)).message

    private suspend fun linkTo(project: Project): String =
        assertIs<LinkCreation.Made>(linkOf(project, Language.ENGLISH)).fragment

    private val broken = "The link is broken or not whole; perhaps a part of it was lost when it was copied."

    @Test
    fun `links hold worlds and projects`() = runTest {
        val world = assertIs<LinkCreation.Made>(linkOf(BuiltInWorlds.plain, Language.ENGLISH)).fragment
        assertTrue(Regex("#w=a[A-Za-z0-9_-]+").matches(world), world)
        assertTrue(world.length < 400, "$world has ${world.length} characters")
        assertEquals<LinkResult>(LinkResult.OfWorld(BuiltInWorlds.plain), openLink(world, Language.ENGLISH))
        assertEquals<LinkResult>(LinkResult.OfProject(FULL_PROJECT), openLink(linkTo(FULL_PROJECT), Language.ENGLISH))
    }

    @Test
    fun `a link may be a whole address with blanks around it`() = runTest {
        val link = linkTo(FULL_PROJECT)
        listOf("https://school.example/robotran/$link", "  $link\n", link.drop(1)).forEach {
            assertEquals<LinkResult>(LinkResult.OfProject(FULL_PROJECT), openLink(it, Language.ENGLISH))
        }
    }

    @Test
    fun `links of other platforms can be read`() = runTest {
        assertNotEquals(RECORDED.first(), RECORDED.last())
        for (link in RECORDED) {
            assertEquals<LinkResult>(
                LinkResult.OfProject(RECORDED_PROJECT),
                openLink(link, Language.ENGLISH),
            )
        }
    }

    @Test
    fun `what is no link is refused`() = runTest {
        val noLink = "This is not a link to a world, a project or a course of Robotran."
        listOf("", "#", "square.robo", "https://school.example/#about", "#x=abc", "w").forEach {
            assertEquals(noLink, refusal(it))
        }
        assertEquals("This link was made by a newer Robotran.", refusal("#w=bAAAA"))
        assertEquals(broken, refusal("#w="))
        assertEquals(broken, refusal("#w=1AAA"))
        assertEquals("The link is too long: more than 100,000 characters.", refusal("#w=a" + "A".repeat(100_000)))
    }

    @Test
    fun `a link that was cut off anywhere is refused`() = runTest {
        val link = linkTo(FULL_PROJECT)
        for (length in 4..<link.length) assertEquals(broken, refusal(link.take(length)))
    }

    @Test
    fun `a link with more of its own letters behind it is refused, what else follows is not part of it`() = runTest {
        listOf("A", "AAAA").forEach { assertEquals(broken, refusal(linkTo(FULL_PROJECT) + it)) }
        listOf("=", ".", " x", "ä", "%20").forEach {
            assertEquals<LinkResult>(
                LinkResult.OfProject(FULL_PROJECT),
                openLink(linkTo(FULL_PROJECT) + it, Language.ENGLISH),
            )
        }
    }

    @Test
    fun `a link with any letter changed gives a result`() = runTest {
        val random = Random(2005)
        val link = linkTo(FULL_PROJECT)
        repeat(500) {
            val place = random.nextInt(4, link.length)
            val letter = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_".random(random)
            when (val result = openLink(link.replaceRange(place, place + 1, letter.toString()), Language.ENGLISH)) {
                is LinkResult.OfProject -> assertEquals<LinkResult>(
                    result,
                    openLink(linkTo(result.project), Language.ENGLISH),
                )
                is LinkResult.Rejected -> assertTrue(result.message.endsWith("."), result.message)
                else -> throw AssertionError("a project became $result")
            }
        }
    }

    @Test
    fun `a link that holds something else says what is wrong with it`() = runTest {
        val link =
            "#w=a" + Base64.UrlSafe.withPadding(Base64.PaddingOption.ABSENT).encode(deflate("{}".encodeToByteArray()))
        assertEquals(
            "What the link holds cannot be used. This is not a Robotran world: a world file says \"format\": " +
                "\"robotran-world\".",
            refusal(link),
        )
        val swapped = refusal(linkTo(FULL_PROJECT).replace("#p=", "#w="))
        assertTrue(
            swapped.startsWith("What the link holds cannot be used. Line 1: This is not a Robotran world"),
            swapped,
        )
    }

    @Test
    fun `a link that would grow without end is refused`() = runTest {
        val bomb = deflate(ByteArray(JsonLimits.MAXIMUM_BYTES + 1))
        assertTrue(bomb.size < 10_000, "${bomb.size} bytes")
        assertEquals(broken, refusal("#p=a" + Base64.UrlSafe.withPadding(Base64.PaddingOption.ABSENT).encode(bomb)))
    }

    @Test
    fun `what is too long for a link is told so`() = runTest {
        val random = Random(1)
        val rows = List(500) { List(400) { "0123456789abcdef".random(random) }.joinToString("") }
        val world = BuiltInWorlds.plain.copy(marks = listOf(Mark(MarkFigure.GreyMap(Point(0.0, 0.0), 0.1, rows))))
        val message = assertIs<LinkCreation.TooLong>(linkOf(world, Language.ENGLISH)).message
        assertEquals(
            "This world is too long for a link: it would take N characters, and 100,000 are the most. Share its file " +
                "instead.",
            message.replaceFirst(Regex("\\d{3},\\d{3}"), "N"),
        )
    }

    private val photo = AssignmentPicture("board", Base64.encode(Random(1).nextBytes(100_000)))

    private fun withPhoto(text: String = ""): Project =
        Project(BuiltInWorlds.plain, assignment = Assignment("a", text = text, pictures = listOf(photo)))

    private suspend fun tooLong(language: Language, made: suspend (Language) -> LinkCreation): String =
        assertIs<LinkCreation.TooLong>(made(language)).message.replaceFirst(Regex("1\\d\\d(\\D)\\d{3}"), "N$1N")

    @Test
    fun `pictures that make a link too long are told to be the reason`() = runTest {
        assertEquals(
            "This project is too long for a link because of its pictures: it would take N,N characters, and 100,000 " +
                "are the most. Share its file instead, or take pictures out.",
            tooLong(Language.ENGLISH) { linkOf(withPhoto(), it) },
        )
        assertEquals(
            "Dieser Kurs ist wegen der Bilder zu lang für einen Link: Er würde N.N Zeichen brauchen, und höchstens " +
                "100.000 gehen. Teil stattdessen die Datei, oder nimm Bilder heraus.",
            tooLong(Language.GERMAN) { linkOf(Course("c", assignments = listOf(withPhoto())), it) },
        )
        assertEquals(
            "Este proyecto es demasiado largo para un enlace por sus imágenes: ocuparía N\u00A0N letras y signos, y " +
                "como mucho pueden ser 100\u00A0000. Comparte mejor su archivo, o quita imágenes.",
            tooLong(Language.SPANISH) { linkOf(withPhoto(), it) },
        )
    }

    @Test
    fun `pictures are not told to be the reason where the rest is too long, too`() = runTest {
        val message = tooLong(Language.ENGLISH) { linkOf(withPhoto(Base64.encode(Random(2).nextBytes(90_000))), it) }
        assertFalse("pictures" in message, message)
    }

    @Test
    fun `any bytes are deflated and inflated again`() = runTest {
        val random = Random(2005)
        listOf(0, 1, 100, 8192, 8193, 100_000).forEach { length ->
            listOf(random.nextBytes(length), ByteArray(length) { (it % 7).toByte() }).forEach { bytes ->
                val compressed = deflate(bytes)
                assertContentEquals(bytes, inflate(compressed, bytes.size))
                if (length > 0) assertNull(inflate(compressed, bytes.size - 1))
            }
        }
        repeat(200) { inflate(random.nextBytes(random.nextInt(50)), 1000) }
    }

    @Test
    fun `arguments that are links can be told from files`() {
        assertTrue(isLink("#w=aAAAA"))
        assertTrue(isLink("https://school.example/#p=aAAAA"))
        assertFalse(isLink("square.robo"))
        assertFalse(isLink("w=1.robo"))
    }

    private companion object {
        /** The full project before the format supported moved blocks. */
        val RECORDED_PROJECT = FULL_PROJECT.copy(
            world = FULL_PROJECT.world.copy(blocks = emptyList()),
            inputs = FULL_PROJECT.inputs.filter { it.input !is SessionInput.PlaceBlock },
        )

        /** The same project as deflated by a JVM and by Node. */
        val RECORDED = listOf(
            "#p=ajVRLkpswEL2KS2vswc7YcVg62yymkqU9CwENaEZIlCRsz7i4RrbZ5AI5Qy6UI6QbYQMzVCW4ykB3" +
                "v9ef1-LCMm1K7ljEjI61M1zNK6OfIH" +
                "EsYEcwVmjFomXg3ZZF-wtTvAQExDrGGIzODS9HHr6gaHRKrvKa59DR0ytaHZwx4Z7FANXBoOHg4vr1dX" +
                "Z3N_v968-Pn98PdYgXOthjE9xYd2PC" +
                "J37kaMmEhFHy3aLzXNMkkls7280uaGtGjJ_fhqIXf0RqrHvwnbFohXlFXrhvoKw2iMOZnbhJ2YCKK8UI" +
                "acE5oXKs6ILPkLJojbMDLoVFpnCxwt" +
                "c2KfpLnYJny8VRtKOxVYthtZKiFA6fmyZgQlV1N3uSKgzYs1AUVhmwFmFx7RzpxLSa6yxrC6PIZR9qQA" +
                "K3MBHcadspOgG1Tlc3-2qQXfIEvrbY" +
                "MUfAziyarxfY6wuLNgErgKfUYLT6GF6JPvREpT7CF15WrcB4o4mfaVrLlaf4dAXdD6o6CZcUIxiuKTWW" +
                "cWnhilj3iFZE1omJBYaL9TVq00c5KC" +
                "sw3NWGhpWAtKK2VG7P2F49QNdJ8W4ClTbUZOA1IlGdqYFW5KSNTEn_90fPuwYHDwfhhJO0Jg-SCzWzBQ" +
                "D1UHEskkhOInUFyRXSmH1nW6x14sDS" +
                "juKKOU6VXWjCJOaLv90kCpvBWvteEi11TYsfyxreUGymKahPLqXPnxmNy7-ngQf0h06n0YBFDyyFSJ4V" +
                "7XO0pAo60DimR23_A7UdoOb_Bs0nMV" +
                "PlPfqN892d28WjGRDXuRUd3-7xU9L8BQ",
            "#p=ajVNBcpswFL2K561lB7txmmqZbrvItEuHhYBvo0QgRhK2Ew_X6LabXqBn6IV6hM4HHCDxTMsCBum9" +
                "p__f-zpha12hAiScTWxwqpxXzj5SGi" +
                "CwJ-e1LSGXotv2kJsTSlUQJBKbQKBydudUMdlRC0ZDwKhyV6sd9fL8C4FAxwC5QUJUPTgIPISkfnmZXV" +
                "3Nfv_68-Pn94c6iqIIAogb8ap6NxV8" +
                "VHsFga02NDn8btHvnI9JjfJ-djc7QaCZKH5-C0XcxE3Mos6H-64zyJWA0bs8fKPSWwfJnh2UyzCSUmUJ" +
                "ZnoKQZc7D3mCJ8og1wKOlNG-gIwWq7" +
                "XoKpcnFDajTm2n97q1xlctB3VpdKEDZWgaAV1Wde89RxUJPOmSYZUj7yGQ1CFwTrDl3G63bWGMXA5QR4" +
                "aUpwvgPts-0QtUH2z1ur4anW5USl9b" +
                "7lRD4Ag5Xy_WAs-QNwI5qYwblKuP0VnowyBU2D19UUXVBlxUreNHdmu56iQ-nUnXo6oOOqT5hLYU4Ma2" +
                "yng6M9YDow0RfZiQ82ixPqNuBlSgoi" +
                "KnQu3YrJSM17XncgfF9hkItk7zdw5U1nGTosuIQw2uJh6Rg3Um4_zfX71ua3TxVgJBB8Njcm-ULmc-J-" +
                "IeKlWRY5GDzkLOcUVsc9fZbdRcurA8" +
                "owI-KK7sxA5zmM_d5zWiqBmNdddLao2tefATU9MbiZvLEtynMqY7f-tsAblhwwW_YoFgITfLaLyS6_Sp" +
                "5HmWS66gJ00xA-v2P1i3I9b836T5Rc" +
                "6l8uJu4rruju3gsQesdWxDf4a8buKm-Qs",
        )
    }

    @Test
    fun `all kinds of links are found in a text, without what is around them`() = runTest {
        val text = "Hi (https://example.org/#p=aX_1-b), #w=aQ. And #c=aR\n#h=aS! #x=aT #p="
        assertEquals(listOf("#p=aX_1-b", "#w=aQ", "#c=aR", "#h=aS"), linksIn(text).map { it.link })
    }
}
