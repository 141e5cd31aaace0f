plugins {
    id("robotran.core")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.programs.robolangPrograms",
        "shared/robolang/src/commonTest/resources/programs",
        "**/*.robo",
    )
    constant("commonTest", "robotran.programs.robolangExamples", "examples", "*.robo")
    constant("commonTest", "robotran.programs.lejosExamples", "examples/lejos", "*.java")
    constant("commonTest", "robotran.programs.expectedRuns", "shared/programs/src/commonTest/resources/runs", "*")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:robolang"))
            api(project(":shared:tinyvm"))
            api(project(":shared:java-compiler"))
            implementation(project(":shared:lejos-library"))
        }
        commonTest.dependencies {
            implementation(project(":shared:simulation"))
        }
    }
}
