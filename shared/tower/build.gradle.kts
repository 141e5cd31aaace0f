plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            implementation(libs.coroutines.core)
        }
        jvmTest.dependencies {
            implementation(libs.kotest.property)
        }
    }
}
