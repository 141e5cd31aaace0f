plugins {
    id("robotran.core")
    id("robotran.physics-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:simulation"))
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
