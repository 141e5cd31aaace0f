plugins {
    id("robotran.compose")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:ui-common"))
            api(project(":shared:ui-program"))
            api(project(":shared:ui-run"))
            api(project(":shared:ui-world"))
            api(project(":shared:ui-school"))
            implementation(libs.coroutines.core)
            // Material, inside the kit, requires 0.6.0, whose wasm library is missing on some registries.
            implementation(libs.datetime)
        }
        androidMain.dependencies {
            // Compose requires 2.8.3, which some mirrors of Google's repository lack.
            implementation(libs.androidx.lifecycle.runtime.compose)
        }
        jvmMain.dependencies {
            implementation(libs.compose.ui.tooling.preview)
        }
        jvmTest {
            kotlin.srcDir("src/sharedTest/kotlin")
            kotlin.srcDir("../workshop/src/sharedTest/kotlin")
        }
        jvmTest.dependencies {
            implementation(libs.kotest.property)
        }
    }
}
