plugins {
    id("robotran.compose")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
            api(libs.compose.runtime)
            api(libs.compose.foundation)
            api(libs.compose.ui)
            implementation(libs.compose.material3) // nowhere else
            implementation(libs.compose.resources)
            implementation(libs.coroutines.core)
            // Material requires 0.6.0, whose wasm library is missing on some registries.
            implementation(libs.datetime)
        }
        androidMain.dependencies {
            // Compose requires 2.8.3, which some mirrors of Google's repository lack.
            implementation(libs.androidx.lifecycle.runtime.compose)
            implementation(libs.androidx.activity.compose) // for Back
        }
        jvmMain.dependencies {
            implementation(libs.compose.ui.tooling.preview)
        }
    }
}

compose.resources {
    packageOfResClass = "robotran.uikit.resources"
}
