package robotran.build

import org.gradle.api.DefaultTask
import org.gradle.api.GradleException
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.file.FileSystemOperations
import org.gradle.api.provider.Property
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputDirectory
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import org.gradle.work.DisableCachingByDefault
import java.io.ByteArrayOutputStream
import java.io.File
import javax.inject.Inject

/**
 * Builds a package of the desktop app for the current system with its own Java runtime, by the JDK's jpackage: `deb`,
 * `msi` or `dmg`.
 *
 * Compose's plugin could do the same, but its tasks have the same names as those of Gradle's application plugin.
 */
@DisableCachingByDefault(because = "what jpackage writes is never the same twice")
abstract class PackageDesktopApp
    @Inject
    constructor(
        private val processes: ExecOperations,
        private val files: FileSystemOperations,
    ) : DefaultTask() {
        /** The app's jars from `installDist`. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val jars: DirectoryProperty

        /** Icons, file associations and replacements of jpackage's templates. */
        @get:InputDirectory
        @get:PathSensitive(PathSensitivity.RELATIVE)
        abstract val resources: DirectoryProperty

        @get:Input
        abstract val type: Property<String>

        @get:Input
        abstract val version: Property<String>

        @get:Input
        abstract val mainClass: Property<String>

        /** The folder of the JDK that runs jpackage and provides the packaged Java runtime. */
        @get:Input
        abstract val javaHome: Property<String>

        @get:OutputDirectory
        abstract val output: DirectoryProperty

        @TaskAction
        fun pack() {
            val system = SYSTEMS.getValue(type.get())
            if (!System.getProperty("os.name").startsWith(system)) {
                throw GradleException(
                    "A .${type.get()} can only be made on $system: jpackage makes packages for its own system only.",
                )
            }
            files.delete { it.delete(output) }
            val image = temporaryDir.resolve("image").also { it.deleteRecursively() }
            run(imageArguments(image))
            makeClassArchive(image)
            run(packageArguments(image.listFiles().orEmpty().single()))
        }

        private fun imageArguments(image: File) = listOf(
            "--type",
            "app-image",
            "--name",
            NAME,
            "--app-version",
            version.get(),
            "--dest",
            image.path,
            "--input",
            jars.get().asFile.path,
            "--main-jar",
            "desktopApp.jar",
            "--main-class",
            mainClass.get(),
            "--icon",
            resourceFile("robotran.$ICON"),
            "--add-modules",
            MODULES.joinToString(","),
            "--jlink-options",
            "--strip-debug --no-man-pages --no-header-files",
            "--java-options",
            "-XX:SharedArchiveFile=\$APPDIR/robotran.jsa",
            "--java-options",
            "-Xshare:auto",
            "--java-options",
            "-XX:+UseSerialGC",
            "--java-options",
            "-Xss2m",
        )

        private fun packageArguments(image: File): List<String> {
            val common =
                listOf(
                    "--type",
                    type.get(),
                    "--name",
                    NAME,
                    "--app-version",
                    version.get(),
                    "--dest",
                    output.get().asFile.path,
                    "--app-image",
                    image.path,
                    "--resource-dir",
                    resources.get().asFile.path,
                    "--vendor",
                    "Robotran",
                    "--description",
                    "Program a simulated LEGO RCX robot in Robolang or Java",
                )
            val associations = KINDS.flatMap { listOf("--file-associations", resourceFile("$it.properties")) }
            val ofSystem =
                when (type.get()) {
                    "deb" -> listOf(
                        "--linux-shortcut",
                        "--linux-menu-group",
                        "Education;",
                        "--linux-app-category",
                        "education",
                    )

                    "msi" -> listOf("--win-menu", "--win-shortcut", "--win-per-user-install")
                    else -> emptyList()
                }
            return common + associations + ofSystem
        }

        /** Creates the class data archive of the JDK's classes, which jlink does not do by default. */
        private fun makeClassArchive(image: File) {
            val java = image.walk().firstOrNull { it.path.endsWith("/bin/java") } ?: return
            processes.exec { it.commandLine(java.path, "-Xshare:dump").standardOutput = ByteArrayOutputStream() }
        }

        private fun resourceFile(name: String) = resources.get().asFile.resolve(name).path

        private fun run(arguments: List<String>) {
            processes.exec { it.commandLine(listOf("${javaHome.get()}/bin/jpackage") + arguments) }
        }

        private companion object {
            const val NAME = "robotran"
            val SYSTEMS = mapOf("deb" to "Linux", "msi" to "Windows", "dmg" to "Mac")
            val KINDS = listOf("project", "robolang")
            val ICON =
                when {
                    System.getProperty("os.name").startsWith("Windows") -> "ico"
                    System.getProperty("os.name").startsWith("Mac") -> "icns"
                    else -> "png"
                }

            /** The JDK modules of the app. `jdk.localedata` provides Spanish and German date formats. */
            val MODULES =
                listOf(
                    "java.base",
                    "java.compiler",
                    "java.datatransfer",
                    "java.desktop",
                    "java.instrument",
                    "java.logging",
                    "java.management",
                    "java.naming",
                    "java.prefs",
                    "java.sql",
                    "java.xml",
                    "jdk.accessibility",
                    "jdk.httpserver",
                    "jdk.localedata",
                    "jdk.unsupported",
                    "jdk.zipfs",
                )
        }
    }
