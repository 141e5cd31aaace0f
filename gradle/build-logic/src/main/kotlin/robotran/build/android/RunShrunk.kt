package robotran.build.android

import com.android.tools.r8.CompilationMode
import com.android.tools.r8.OutputMode
import com.android.tools.r8.R8
import com.android.tools.r8.R8Command
import com.android.tools.r8.origin.Origin
import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.Directory
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFile
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import java.io.ByteArrayOutputStream
import java.io.File
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import java.util.zip.ZipOutputStream
import javax.inject.Inject

/**
 * Lets R8 shrink the app once more with the rules of its release, into class files this time, together with a program that uses it; then runs that on a JVM. What
 * R8 takes away too much is missing there, too.
 */
@CacheableTask
abstract class RunShrunk
    @Inject
    constructor(
        private val processes: ExecOperations,
    ) : DefaultTask() {
        /** Jars with all classes of the app and its libraries. */
        @get:Classpath
        abstract val jars: ListProperty<RegularFile>

        /** The same in folders. */
        @get:Classpath
        abstract val folders: ListProperty<Directory>

        /** Jars with what else is on the class path; classes in them do not count. */
        @get:Classpath
        abstract val resourceJars: ListProperty<RegularFile>

        /** The same in folders. */
        @get:Classpath
        abstract val resourceFolders: ListProperty<Directory>

        /** Folders with the class files of the program. */
        @get:Classpath
        abstract val program: ConfigurableFileCollection

        /** Which of them, by the folder of their package. */
        @get:Input
        abstract val programPackage: Property<String>

        /** Its class with `main`, whose argument is [tree]. */
        @get:Input
        abstract val mainClass: Property<String>

        @get:Internal
        abstract val tree: DirectoryProperty

        /** What the program reads of [tree]. */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val read: ConfigurableFileCollection

        /** R8's whole configuration, as the release was shrunk with it. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val configuration: RegularFileProperty

        /** `android.jar`. */
        @get:Classpath
        abstract val framework: ConfigurableFileCollection

        @get:OutputFile
        abstract val shrunk: RegularFileProperty

        /** What the program has said. */
        @get:OutputFile
        abstract val report: RegularFileProperty

        @TaskAction
        fun shrinkAndRun() {
            shrink()
            val resourceJar = temporaryDir.resolve("resources.jar").also(::writeResources)
            val said = ByteArrayOutputStream()
            processes.javaexec {
                it.classpath(shrunk.get().asFile, resourceJar)
                it.mainClass.set(mainClass)
                it.args(tree.get().asFile.path)
                it.standardOutput = said
            }
            report.get().asFile.writeText(said.toString())
            logger.lifecycle(said.toString().trim())
        }

        private fun shrink() {
            // It would write over the release's own reports.
            val rules = configuration.get().asFile.readLines().filterNot { it.startsWith("-print") }
            val keepProgram = "-keep class ${mainClass.get()} { public static void main(java.lang.String[]); }"
            val command = R8Command.builder()
                .addProgramFiles(jars.get().map { it.asFile.toPath() })
                .addProgramFiles((folders.get().map { it.asFile } + program.files).flatMap(::classesIn).map { it.toPath() })
                .addLibraryFiles(framework.map { it.toPath() })
                .addProguardConfiguration(rules + keepProgram, Origin.unknown())
                .setMode(CompilationMode.RELEASE)
                .setOutput(shrunk.get().asFile.toPath(), OutputMode.ClassFile)
            R8.run(command.build())
        }

        private fun classesIn(folder: File): List<File> = folder.walk().filter { file ->
            val isOwn = folder !in program || file.toRelativeString(folder).replace(File.separatorChar, '/').startsWith(programPackage.get())
            file.extension == "class" && isOwn
        }.toList()

        private fun writeResources(jar: File) = ZipOutputStream(jar.outputStream()).use { zip ->
            val written = mutableSetOf<String>()
            val write = { name: String, bytes: () -> ByteArray ->
                if (!name.endsWith(".class") && !name.endsWith("/") && written.add(name)) {
                    zip.putNextEntry(ZipEntry(name))
                    zip.write(bytes())
                    zip.closeEntry()
                }
            }
            for (source in resourceJars.get().map { it.asFile } + resourceFolders.get().map { it.asFile }) {
                if (source.isDirectory) {
                    source.walk().filter { it.isFile }.forEach { write(it.toRelativeString(source)) { it.readBytes() } }
                } else {
                    ZipFile(source).use { from ->
                        from.entries().asSequence().forEach { entry -> write(entry.name) { from.getInputStream(entry).use { it.readBytes() } } }
                    }
                }
            }
        }
    }
