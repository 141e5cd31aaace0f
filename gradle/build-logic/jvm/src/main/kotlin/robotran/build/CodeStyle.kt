package robotran.build

import org.gradle.api.Project
import org.gradle.api.attributes.Bundling
import org.gradle.api.file.FileCollection
import org.gradle.api.tasks.JavaExec
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskProvider

/**
 * Runs ktlint on all Kotlin files of the tree, including build scripts. ktlint uses the parser of the Kotlin compiler
 * and fails on invalid Kotlin. This keeps the build scripts valid Kotlin, although an embedded Gradle reads them as
 * Groovy.
 */
object CodeStyle {
    fun register(project: Project) {
        val libraries = catalog(project)
        val ktlint =
            project.configurations.create("ktlint") {
                // The command line as one jar; the other variant lacks some of its dependencies.
                it.attributes.attribute(
                    Bundling.BUNDLING_ATTRIBUTE,
                    project.objects.named(Bundling::class.java, Bundling.SHADOWED),
                )
            }
        project.dependencies.add(ktlint.name, libraries.findLibrary("ktlint").get())

        val scripts = kotlinFiles(project, "**/*.gradle.kts")
        val sources = kotlinFiles(project, "**/src/**/*.kt")
        val checkScripts =
            ktlintTask(
                project,
                ktlint,
                "checkBuildScripts",
                "Checks that every build script is legal Kotlin, in our style.",
                scripts,
            )
        val checkStyle =
            ktlintTask(project, ktlint, "checkCodeStyle", "Checks that all Kotlin is in the project's style.", sources)
        checkStyle.configure { it.mustRunAfter(checkScripts) }
        project.tasks.register("formatCode", JavaExec::class.java) { task ->
            task.group = "formatting"
            task.description = "Puts all Kotlin into the project's style."
            task.classpath(ktlint)
            task.mainClass.set(MAIN)
            task.jvmArgs(JVM_OPTIONS)
            task.workingDir = project.rootDir
            task.args("--relative", "--format")
            task.argumentProviders.add { paths(project, scripts) + paths(project, sources) }
        }
        project.tasks.named("check") { it.dependsOn(checkScripts, checkStyle) }
    }

    private fun ktlintTask(
        project: Project,
        ktlint: FileCollection,
        name: String,
        description: String,
        files: FileCollection,
    ): TaskProvider<JavaExec> = project.tasks.register(name, JavaExec::class.java) { task ->
        task.group = "verification"
        task.description = description
        task.classpath(ktlint)
        task.mainClass.set(MAIN)
        task.jvmArgs(JVM_OPTIONS)
        task.workingDir = project.rootDir
        val report = project.layout.buildDirectory.file("reports/ktlint/$name.txt")
        task.args("--relative", "--reporter=plain", "--reporter=plain,output=${report.get().asFile}")
        task.argumentProviders.add { paths(project, files) }
        task.inputs.files(files).withPropertyName("files").withPathSensitivity(PathSensitivity.RELATIVE)
        task.inputs.file(
            project.file(".editorconfig"),
        ).withPropertyName("style").withPathSensitivity(PathSensitivity.NONE)
        task.outputs.file(report)
    }

    private fun kotlinFiles(project: Project, pattern: String): FileCollection = project.fileTree(project.rootDir) {
        it.include(pattern)
        it.exclude("build/**", "*/build/**", "shared/*/build/**", "gradle/build-logic/*/build/**", "**/.*/**")
    }

    private fun paths(project: Project, files: FileCollection): List<String> =
        files.files.map { it.relativeTo(project.rootDir).invariantSeparatorsPath }.sorted()

    private const val MAIN = "com.pinterest.ktlint.Main"
    private val JVM_OPTIONS = listOf("-Xmx768m", "-XX:+UseSerialGC", "--add-opens=java.base/java.lang=ALL-UNNAMED")
}
