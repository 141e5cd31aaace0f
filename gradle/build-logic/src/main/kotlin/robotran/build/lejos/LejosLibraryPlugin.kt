package robotran.build.lejos

import org.gradle.api.Plugin
import org.gradle.api.Project
import org.jetbrains.kotlin.gradle.dsl.KotlinMultiplatformExtension
import robotran.build.catalog
import robotran.build.texts.GenerateTexts

/** Gives a multiplatform module the class files of its Java in `src/brick/java` as the constant `robotran.lejos.libraryClasses`, in Base64. */
class LejosLibraryPlugin : Plugin<Project> {
    override fun apply(project: Project) {
        val compiler = project.configurations.create("brickCompiler") {
            it.isCanBeConsumed = false
            it.isCanBeResolved = true
        }
        project.dependencies.add(compiler.name, catalog(project).findLibrary("ecj").get())
        val compile = project.tasks.register("compileForBrick", CompileForBrick::class.java) { task ->
            task.compiler.from(compiler)
            task.sources.set(project.fileTree("src/brick/java") { it.include("**/*.java") })
            task.classFolder.set(project.layout.buildDirectory.dir("brick/classes"))
            task.textFolder.set(project.layout.buildDirectory.dir("brick/texts"))
        }
        val generate = project.tasks.register("generateLibraryClasses", GenerateTexts::class.java) { task ->
            task.texts.set(compile.map { compiled -> project.fileTree(compiled.textFolder) { it.builtBy(compiled) } })
            task.qualifiedName.set("robotran.lejos.libraryClasses")
            task.outputFolder.set(project.layout.buildDirectory.dir("generated/texts/libraryClasses"))
        }
        val kotlin = project.extensions.getByType(KotlinMultiplatformExtension::class.java)
        kotlin.sourceSets.getByName("commonMain").kotlin.srcDir(generate)
    }
}
