package robotran.build

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.gradle.api.file.ConfigurableFileTree
import org.gradle.api.tasks.testing.Test
import robotran.build.messages.Messages
import robotran.build.messages.MissingMessages

/** Configures the root project. It holds no code, only checks of the whole tree and tasks shared by all modules. */
class RootPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        project.group = "robotran"
        project.pluginManager.apply("base")
        Rings.register(project)
        project.objects.newInstance(TaskTimes.Registration::class.java).register(project)
        val setUp =
            project.tasks.register("setUp") { task ->
                task.group = "build setup"
                task.description = "Sets up everything that this machine lacks for the build."
            }
        val targets = Targets.of(project)
        if (targets.wasm) project.pluginManager.apply("robotran.web-tools")
        if (targets.compose) {
            FindPrograms.registerSetUp(project)
            setUp.configure { it.dependsOn(FindPrograms.DISPLAY, FindPrograms.ENGINES) }
        }
        project.subprojects { module ->
            // Test processes are short-lived and run side by side, so threads of a garbage collector and of the
            // optimising compiler are in the way.
            module.tasks.withType(Test::class.java).configureEach {
                it.jvmArgs("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1")
            }
        }
        CodeStyle.register(project)
        project.tasks.register("missingMessages", MissingMessages::class.java) { task ->
            task.group = "help"
            task.description = "Lists what a language lacks: messages, lessons, tasks of worlds, help on words."
            task.catalogues.from(sources(project, CATALOGUES))
            task.texts.from(project.fileTree("learning").matching { it.include("**/*.md").exclude("README.md") })
            task.texts.from(project.fileTree("shared/nqc/src/api"))
            task.root.set(project.layout.projectDirectory.asFile.path)
            task.languages.set(project.file(Messages.LANGUAGES))
        }
        val moduleMap = registerModuleMapCheck(project)
        val wrapper = registerWrapperCheck(project)
        val buildLogic = project.gradle.includedBuild("build-logic")
        project.tasks.named("check") { task ->
            task.dependsOn(moduleMap, wrapper)
            task.dependsOn(listOf("jvm", "web").map { buildLogic.task(":$it:test") })
            // These take longest. Gradle prefers the tasks of the root project, so they begin as soon as they can.
            if (targets.isComplete) {
                task.dependsOn(":webApp:browserTest", ":shared:ui:jvmTest", ":wasmTests:wasmJsNodeTest")
            }
        }
        Rings.addToQuick(project, moduleMap, CodeStyle.CHECK_STYLE, CodeStyle.CHECK_SCRIPTS)
        if (targets.android) Rings.addToAll(project, buildLogic.task(":android:test"))
    }

    private fun registerModuleMapCheck(project: Project) =
        project.tasks.register("checkModuleMap", CheckModuleMap::class.java) { task ->
            task.group = "verification"
            task.description = "Checks that no module imports what the module map in docs/modules.md forbids."
            task.map.set(project.file("docs/modules.md"))
            val kinds = listOf("**/src/**/*.kt", "**/src/**/*.java", CATALOGUES)
            task.sources.from(kinds.map { sources(project, it) })
            task.root.set(project.layout.projectDirectory)
            task.report.set(project.layout.buildDirectory.file("reports/module-map.txt"))
        }

    private fun registerWrapperCheck(project: Project) =
        project.tasks.register("checkGradleWrapper", CheckGradleWrapper::class.java) { task ->
            task.group = "verification"
            task.description =
                "Checks that gradle-wrapper.jar is the official one and that the distribution's checksum is pinned."
            task.jar.set(project.file("gradle/wrapper/gradle-wrapper.jar"))
            task.properties.set(project.file("gradle/wrapper/gradle-wrapper.properties"))
        }

    /** The source files of the tree's modules that match [pattern], without build output and build logic. */
    private fun sources(project: Project, pattern: String): ConfigurableFileTree = project.fileTree(project.rootDir) {
        it.include(pattern)
        it.exclude("build/**", "*/build/**", "shared/*/build/**", "**/.*/**", "gradle/**")
        // Java code for the brick, not for the computer.
        it.exclude("**/src/brick/**", "**/src/*/resources/**")
    }

    private companion object {
        const val CATALOGUES = "**/src/*/messages/*.md"
    }
}
