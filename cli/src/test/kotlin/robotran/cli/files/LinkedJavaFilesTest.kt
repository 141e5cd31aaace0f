package robotran.cli.files

import robotran.cli.CommandTest
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.test.Test
import kotlin.test.assertEquals

/** Symbolic links among the files of one program in Java, in every command that reads them. */
class LinkedJavaFilesTest : CommandTest() {
    private val world = tree.resolve("worlds/maze.world.json").path
    private val work = folder.resolve("work").createDirectories()
    private val mine = program("class Mine { public static void main(String[] args) { } }\n", "work/Mine.java")

    init {
        program("class Secret { }\n", "Secret.java")
    }

    private fun link(name: String, target: String): String =
        work.resolve(name).createSymbolicLinkPointingTo(Path.of(target)).toString()

    private fun isRefused(vararg command: String, link: String) {
        console.complaints.clear()
        console.said.clear()
        assertEquals(2, commandLine.execute(command.toList()), "${command.toList()}")
        val described = console.complaints.filter {
            "$link is a link to a file outside of its folder, and is not read." in it
        }
        assertEquals(1, described.size, "${command.toList()}: ${console.complaints}")
    }

    @Test
    fun `of several files, those outside of the program's folder are not read`() {
        val link = link("Secret.java", "../Secret.java")
        for (command in listOf("run", "check", "build", "link", "send")) {
            isRefused(command, mine, link, link = link)
            isRefused(command, link, mine, link = link)
        }
        isRefused("translate", mine, link, "--kit", "$folder/kit.zip", link = link)
    }

    @Test
    fun `a folder with a program reads none either`() {
        val link = link("Secret.java", "../Secret.java")
        isRefused("grade", world, "$work", link = link)
        Path.of(mine).toFile().delete()
        isRefused("grade", world, "$work", link = link)
    }

    @Test
    fun `compiled classes that lie beside the named one are not read from elsewhere`() {
        val link = link("Mine\$Wheel.class", "../Secret.java")
        val named = program("no class", "work/Mine.class")
        for (command in listOf("run", "check", "build")) isRefused(command, named, link = link)
    }

    @Test
    fun `a link that is named alone is read, and so is one that stays in the folder`() {
        program("class Alone { public static void main(String[] args) { } }\n", "Alone.java")
        assertEquals(
            0,
            commandLine.execute(listOf("check", link("Alone.java", "../Alone.java"))),
            "${console.complaints}",
        )
        program("class Part { }\n", "work/parts/Part.java")
        val part = link("Part.java", "parts/Part.java")
        assertEquals(0, commandLine.execute(listOf("check", mine, part)), "${console.complaints}")
    }
}
