plugins {
    id("robotran.core")
}

kotlin {
    sourceSets {
        jvmTest.dependencies {
            implementation(libs.kotest.property)
        }
    }
}
