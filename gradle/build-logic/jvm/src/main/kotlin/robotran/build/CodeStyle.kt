package robotran.build

import org.gradle.api.Project
import org.gradle.api.attributes.Bundling
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.file.FileCollection

/**
 * Runs ktlint on all Kotlin files of the tree, including build scripts. ktlint uses the parser of the Kotlin compiler
 * and fails on invalid Kotlin. This keeps the build scripts valid Kotlin, although an embedded Gradle reads them as
 * Groovy.
 */
object CodeStyle {
    const val CHECK_SCRIPTS = "checkBuildScripts"
    const val CHECK_STYLE = "checkCodeStyle"

    fun register(project: Project) {
        val ktlint = ktlint(project)
        val scripts = kotlinFiles(project, "**/*.gradle.kts")
        val sources = kotlinFiles(project, "**/src/**/*.kt")
        project.tasks.withType(Ktlint::class.java).configureEach { task ->
            task.classpath.from(ktlint)
            task.style.set(project.file(".editorconfig"))
            task.root.set(project.layout.projectDirectory)
            task.report.set(project.layout.buildDirectory.file("reports/ktlint/${task.name}.txt"))
        }
        val checkScripts = project.tasks.register(CHECK_SCRIPTS, Ktlint::class.java) {
            it.group = "verification"
            it.description = "Checks that every build script is legal Kotlin, in our style."
            it.files.from(scripts)
        }
        val checkStyle = project.tasks.register(CHECK_STYLE, Ktlint::class.java) {
            it.group = "verification"
            it.description = "Checks that all Kotlin is in the project's style."
            it.files.from(sources)
        }
        project.tasks.register("formatCode", Ktlint::class.java) {
            it.group = "formatting"
            it.description = "Puts all Kotlin into the project's style."
            it.files.from(scripts, sources)
            it.format.set(true)
            // It changes its own inputs.
            it.outputs.upToDateWhen { false }
            it.outputs.doNotCacheIf("it changes its own inputs") { true }
        }
        project.tasks.named("check") { it.dependsOn(checkScripts, checkStyle) }
    }

    private fun ktlint(project: Project): FileCollection {
        val ktlint = project.configurations.create("ktlint") {
            // The command line as one jar; the other variant lacks some of its dependencies.
            it.attributes.attribute(
                Bundling.BUNDLING_ATTRIBUTE,
                project.objects.named(Bundling::class.java, Bundling.SHADOWED),
            )
        }
        project.dependencies.add(ktlint.name, catalog(project).findLibrary("ktlint").get())
        return ktlint
    }

    private fun kotlinFiles(project: Project, pattern: String): ConfigurableFileTree =
        project.fileTree(project.rootDir) {
            it.include(pattern)
            it.exclude("build/**", "*/build/**", "shared/*/build/**", "gradle/build-logic/*/build/**", "**/.*/**")
        }
}
