package robotran.build.android

import com.android.tools.r8.CompilationMode
import com.android.tools.r8.OutputMode
import com.android.tools.r8.R8
import com.android.tools.r8.R8Command
import com.android.tools.r8.origin.Origin
import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.RegularFileProperty
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
import javax.inject.Inject

/**
 * Lets R8 shrink what lies below the screen once more with the rules of the release, into class files this time,
 * together with a program that uses it; then runs that on a JVM. What R8 takes away too much is missing there, too.
 */
@CacheableTask
abstract class RunR8Output
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        /** Jars with what is to be shrunk. */
        @get:Classpath
        abstract val libraries: ConfigurableFileCollection

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
            val said = ByteArrayOutputStream()
            processes.javaexec {
                it.classpath(shrunk)
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
                .addProgramFiles(libraries.map { it.toPath() })
                .addProgramFiles(program.flatMap(::classesIn).map { it.toPath() })
                .addLibraryFiles(framework.map { it.toPath() })
                .addProguardConfiguration(rules + keepProgram, Origin.unknown())
                .setMode(CompilationMode.RELEASE)
                .setOutput(shrunk.get().asFile.toPath(), OutputMode.ClassFile, true)
            R8.run(command.build())
        }

        private fun classesIn(folder: File): List<File> =
            folder.resolve(programPackage.get()).walk().filter { it.extension == "class" }.toList()
    }
