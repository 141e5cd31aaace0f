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
 * Shrinks the code below the UI again, together with a program that uses it. It uses the release's R8 rules but writes
 * class files, then runs the program on a JVM. The run fails if R8 removes too much.
 */
@CacheableTask
abstract class RunR8Output
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        /** The jars to shrink. */
        @get:Classpath
        abstract val libraries: ConfigurableFileCollection

        /** Folders with the class files of the program. */
        @get:Classpath
        abstract val program: ConfigurableFileCollection

        /** The package folder of the classes to use. */
        @get:Input
        abstract val programPackage: Property<String>

        /** The main class; its argument is [tree]. */
        @get:Input
        abstract val mainClass: Property<String>

        @get:Internal
        abstract val tree: DirectoryProperty

        /** The files in [tree] that the program reads. */
        @get:InputFiles
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val read: ConfigurableFileCollection

        /** R8's full configuration of the release. */
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val configuration: RegularFileProperty

        /** `android.jar`. */
        @get:Classpath
        abstract val framework: ConfigurableFileCollection

        @get:OutputFile
        abstract val shrunk: RegularFileProperty

        /** The output of the program. */
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
            // They would overwrite the release's reports.
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
