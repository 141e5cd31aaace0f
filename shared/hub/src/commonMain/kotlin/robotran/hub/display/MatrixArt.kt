package robotran.hub.display

/** What the lights of a matrix show for numbers and characters; `#` is a light. Eight side by side. */
internal object MatrixArt {
    /** The digits 0 to 9, two lights wide. */
    const val DIGITS = """
## .# ## ## #. ## #. ## ## ##
## ## .# .# #. #. #. .# ## ##
## .# ## ## ## ## ## .# ## ##
## .# #. .# .# .# ## .# ## .#
## .# ## ## .# ## ## .# ## .#
"""
}
