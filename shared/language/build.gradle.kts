plugins {
    id("robotran.core")
    id("robotran.languages")
}
