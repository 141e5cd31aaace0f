plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.blockediting.examplePrograms", "examples", "**/*.robo")
    constant("commonTest", "robotran.blockediting.tutorialPrograms", "learning/lessons", "*/*/*.robo")
    constant("commonTest", "robotran.blockediting.wordPages", "learning/words", "robolang.md")
    constant(
        "commonTest",
        "robotran.blockediting.testPrograms",
        "shared/robolang/src/commonTest/resources/programs",
        "**/*.robo",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:robolang"))
            api(project(":shared:text-editing"))
        }
        jvmTest {
            // Random programs and texts, shared with the tests of the language.
            kotlin.srcDir(rootProject.file("shared/robolang/src/jvmTest/kotlin/robotran/robolang/fuzz"))
            resources.srcDir(rootProject.file("shared/robolang/src/jvmTest/resources"))
        }
    }
}
