plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.physics-web")
    id("robotran.texts")
    id("robotran.brick-programs")
    id("robotran.nxj-web")
}

texts {
    constant("commonTest", "robotran.simulation.penbotPages", "docs", "penbot.md")
    constant("jvmTest", "robotran.simulation.nxtPages", "docs", "nxt.md")
    constant("commonTest", "robotran.simulation.nxtRuns", "shared/simulation/src/commonTest/resources/nxt-runs", "*")
    constant("commonTest", "robotran.simulation.exampleTexts", "examples", "*.robo")
    constant("commonTest", "robotran.simulation.expectedRuns", "shared/simulation/src/commonTest/resources/runs", "*")
}

brickPrograms {
    constant("commonTest", "robotran.simulation.steppedPrograms", "shared/simulation/src/commonTest/resources/java")
    nxjConstant("commonTest", "robotran.simulation.nxjPrograms", "shared/simulation/src/commonTest/resources/nxj")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:nxt"))
            api(project(":shared:hub"))
            api(project(":shared:microbit"))
            api(project(":shared:rcx-rom"))
            api(project(":shared:world"))
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
            implementation(project(":shared:tinyvm"))
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:nxj-library"))
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
