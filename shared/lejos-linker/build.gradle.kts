plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.lejoslinker.vectorFiles",
        "shared/lejos-linker/src/commonTest/resources/vectors",
        "*.txt",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:tinyvm"))
        }
        commonTest.dependencies {
            implementation(project(":shared:lejos-library"))
        }
    }
}
