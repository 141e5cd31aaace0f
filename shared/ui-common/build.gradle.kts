plugins {
    id("robotran.compose")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:uikit"))
            api(project(":shared:workshop"))
            implementation(project(":shared:nxt"))
            implementation(project(":shared:hub"))
            implementation(project(":shared:microbit"))
            implementation(project(":shared:scene3d"))
            implementation(libs.compose.resources)
            implementation(libs.coroutines.core)
            // Material, inside the kit, requires 0.6.0, whose wasm library is missing on some registries.
            implementation(libs.datetime)
        }
        androidMain.dependencies {
            // Compose requires 2.8.3, which some mirrors of Google's repository lack.
            implementation(libs.androidx.lifecycle.runtime.compose)
        }
        jvmTest {
            kotlin.srcDir("../ui/src/sharedTest/kotlin")
            kotlin.srcDir("../workshop/src/sharedTest/kotlin")
        }
        jvmTest.dependencies {
            implementation(project(":shared:ui")) // the tests show the whole app
            implementation(libs.kotest.property)
        }
    }
}

compose.resources {
    packageOfResClass = "robotran.ui.resources"
}
