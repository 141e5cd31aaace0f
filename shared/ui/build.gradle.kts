plugins {
    id("com.android.library")
    id("robotran.android")
    id("robotran.compose")
    id("robotran.texts")
    id("org.jetbrains.kotlin.plugin.serialization")
}

android {
    namespace = "robotran.ui"
}

texts {
    constant("commonMain", "robotran.ui.exampleTexts", "examples", "*.robo")
    constant("commonMain", "robotran.ui.lejosExampleTexts", "examples/lejos", "*.java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:robolang"))
            api(project(":shared:programs"))
            api(project(":shared:simulation"))
            api(project(":shared:run-control"))
            api(project(":shared:projects"))
            api(project(":shared:learning"))
            api(project(":shared:text-editing"))
            implementation(project(":shared:qr-code"))
            api(project(":shared:world-editing"))
            api(project(":shared:documents"))
            api(libs.compose.runtime)
            api(libs.compose.foundation)
            api(libs.compose.material3)
            api(libs.compose.ui)
            implementation(libs.compose.resources)
            implementation(libs.coroutines.core)
            // Material asks for 0.6.0, whose wasm library is not on every registry.
            implementation(libs.datetime)
        }
        androidMain.dependencies {
            // Compose asks for 2.8.3, which not every mirror of Google's repository has.
            implementation(libs.androidx.lifecycle.runtime.compose)
            implementation(libs.androidx.activity.compose) // for Back
        }
        jvmTest.dependencies {
            implementation(libs.kotest.property)
            implementation(libs.zxing)
        }
    }
}

compose.resources {
    packageOfResClass = "robotran.ui.resources"
}
