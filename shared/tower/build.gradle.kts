plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.tower.recordedStreams", "shared/tower/src/commonTest/resources/streams", "*")
    constant("commonTest", "robotran.tower.sampleImages", "shared/tower/src/commonTest/resources/images", "*.hex")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:lego-firmware"))
            implementation(libs.coroutines.core)
        }
        commonTest {
            // A brick and a tower for the tests of all modules that talk to one.
            kotlin.srcDir("src/simulatedBrick/kotlin")
            // What it received, on the virtual brick.
            kotlin.srcDir("src/sharedTest/kotlin")
        }
    }
}
