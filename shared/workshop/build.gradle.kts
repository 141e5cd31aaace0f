plugins {
    id("robotran.core")
    id("org.jetbrains.kotlin.plugin.compose")
    id("org.jetbrains.kotlin.plugin.serialization")
    id("robotran.ecj-web")
    id("robotran.physics-web")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.workshop.examples.exampleTexts", "examples", "*.robo")
    constant("commonMain", "robotran.workshop.examples.lejosExampleTexts", "examples/lejos", "*.java")
    constant("commonMain", "robotran.workshop.examples.nxjExampleTexts", "examples/nxj", "*.java")
    constant("commonMain", "robotran.workshop.examples.nqcExampleTexts", "examples/nqc", "*.nqc")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:lego-firmware"))
            api(project(":shared:robolang"))
            api(project(":shared:programs"))
            api(project(":shared:simulation"))
            api(project(":shared:run-control"))
            api(project(":shared:narration"))
            api(project(":shared:run-sound"))
            api(project(":shared:projects"))
            api(project(":shared:learning"))
            api(project(":shared:assignments"))
            api(project(":shared:text-editing"))
            api(project(":shared:block-editing"))
            api(project(":shared:world-editing"))
            api(project(":shared:robot-editing"))
            api(project(":shared:documents"))
            api(project(":shared:animated-picture"))
            api(project(":shared:tower"))
            api(project(":shared:hub-link"))
            api(project(":shared:microbit-link"))
            api(project(":shared:mpy-compiler"))
            api(libs.compose.runtime)
            implementation(project(":shared:nqc"))
            implementation(project(":shared:nxj-library"))
            implementation(libs.coroutines.core)
        }
        jvmMain.dependencies {
            implementation(libs.zxing)
        }
        jvmTest {
            // The tests of shared/ui use them too.
            kotlin.srcDir("src/sharedTest/kotlin")
            kotlin.srcDir("../tower/src/simulatedBrick/kotlin")
            kotlin.srcDir("../tower/src/sharedTest/kotlin")
            kotlin.srcDir("../hub-link/src/simulatedHub/kotlin")
            kotlin.srcDir("../microbit-link/src/simulatedBoard/kotlin")
            resources.srcDir("../microbit-link/src/commonTest/resources")
        }
    }
}
