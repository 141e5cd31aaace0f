package robotran.cli.run

import robotran.lejoslibrary.LejosLibrary
import java.nio.file.Path
import java.util.jar.Attributes
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import java.util.jar.Manifest
import javax.tools.ToolProvider
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.outputStream
import kotlin.io.path.writeBytes
import kotlin.test.assertEquals

/** Class files compiled by the JDK for Java 8 against our leJOS, in folders under [folder]. */
internal class Compiled(private val folder: Path) {
    private val library: Path by lazy {
        folder.resolve("leJOS").also { library ->
            for (name in LejosLibrary.classNames.filter { it.startsWith("josx/") }) {
                library.resolve(
                    "$name.class",
                ).createParentDirectories().writeBytes(checkNotNull(LejosLibrary.classFile(name)))
            }
        }
    }

    /** Compiles [sources] and returns the folder with the class files. */
    fun classes(vararg sources: String): Path {
        val classes = folder.resolve("classes").createDirectories()
        val options =
            arrayOf("--release", "8", "-nowarn", "-Xlint:-options", "-classpath", "$library", "-d", "$classes")
        assertEquals(0, ToolProvider.getSystemJavaCompiler().run(null, null, null, *options, *sources))
        return classes
    }

    /** A jar of [entries] whose manifest names [mainClass], if any. */
    fun jar(entries: Map<String, ByteArray>, mainClass: String? = null): String {
        val manifest = Manifest()
        manifest.mainAttributes[Attributes.Name.MANIFEST_VERSION] = "1.0"
        if (mainClass != null) manifest.mainAttributes[Attributes.Name.MAIN_CLASS] = mainClass
        val file = folder.resolve("program.jar")
        JarOutputStream(file.outputStream(), manifest).use { jar ->
            for ((name, content) in entries) {
                jar.putNextEntry(JarEntry(name))
                jar.write(content)
            }
        }
        return file.toString()
    }

    /** All class files under [classes] by their jar entry names, sorted by name. */
    fun entries(classes: Path): Map<String, ByteArray> {
        val files = classes.toFile().walk().filter { it.isFile }
        return files.associate {
            it.relativeTo(classes.toFile()).invariantSeparatorsPath to it.readBytes()
        }.toSortedMap()
    }
}
