package robotran.build.lejos

import org.gradle.api.DefaultTask
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import java.io.ByteArrayOutputStream
import java.io.DataOutputStream
import java.io.File

/**
 * Packs a class library into the files `nxj-classes.bin` and `nxj-sources.bin`, uncompressed, since jars and web
 * servers compress them. Each is a list of files in the order of their paths: the path as `writeUTF` writes it, the
 * length in four bytes, and the content. The output is reproducible.
 */
@CacheableTask
abstract class PackLibrary : DefaultTask() {
    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val classFolder: DirectoryProperty

    @get:InputDirectory
    @get:PathSensitive(PathSensitivity.RELATIVE)
    abstract val sourceFolder: DirectoryProperty

    /** Receives the two files in the folder of the package that reads them. */
    @get:OutputDirectory
    abstract val resourceFolder: DirectoryProperty

    /** Receives the two files and the module that fetches them. */
    @get:OutputDirectory
    abstract val webFolder: DirectoryProperty

    @TaskAction
    fun pack() {
        val module = checkNotNull(PackLibrary::class.java.getResource(MODULE)) { "There is no $MODULE" }.readText()
        val files = mapOf(
            "nxj-classes.bin" to packed(classFolder.get().asFile),
            "nxj-sources.bin" to packed(sourceFolder.get().asFile),
        )
        write(resourceFolder.get().asFile.resolve(PACKAGE), files)
        write(webFolder.get().asFile, files + (MODULE to module.toByteArray()))
    }

    private fun packed(folder: File): ByteArray {
        val packed = ByteArrayOutputStream()
        val output = DataOutputStream(packed)
        val files = folder.walk().filter { it.isFile }.associateBy { it.relativeTo(folder).invariantSeparatorsPath }
        for ((path, file) in files.toSortedMap()) {
            val content = file.readBytes()
            output.writeUTF(path)
            output.writeInt(content.size)
            output.write(content)
        }
        return packed.toByteArray()
    }

    private fun write(folder: File, files: Map<String, ByteArray>) {
        folder.deleteRecursively()
        folder.mkdirs()
        files.forEach { (name, content) -> folder.resolve(name).writeBytes(content) }
    }

    private companion object {
        const val MODULE = "nxj-library.mjs"
        const val PACKAGE = "robotran/nxjlibrary"
    }
}
