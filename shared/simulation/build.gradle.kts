plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.physics-web")
    id("robotran.texts")
    id("robotran.brick-programs")
}

texts {
    constant("commonTest", "robotran.simulation.penbotPages", "docs", "penbot.md")
    constant("commonTest", "robotran.simulation.exampleTexts", "examples", "*.robo")
    constant("commonTest", "robotran.simulation.expectedRuns", "shared/simulation/src/commonTest/resources/runs", "*")
}

brickPrograms {
    constant("commonTest", "robotran.simulation.steppedPrograms", "shared/simulation/src/commonTest/resources/java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:world"))
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
            implementation(project(":shared:tinyvm"))
            implementation(project(":shared:lejos-library"))
        }
        jvmTest {
            kotlin.srcDir("../world/src/arbitraryWorlds/kotlin")
        }
        jvmMain.dependencies {
            implementation(project(":shared:physics"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
