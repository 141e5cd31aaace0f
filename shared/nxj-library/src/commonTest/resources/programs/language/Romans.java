public class Romans {
    private static final int[] VALUES = {1000, 900, 500, 400, 100, 90, 50, 40, 10, 9, 5, 4, 1};
    private static final String[] SIGNS = {"M", "CM", "D", "CD", "C", "XC", "L", "XL", "X", "IX", "V", "IV", "I"};

    static String roman(int number) {
        StringBuilder roman = new StringBuilder();
        for (int i = 0; i < VALUES.length; i++) {
            while (number >= VALUES[i]) {
                roman.append(SIGNS[i]);
                number -= VALUES[i];
            }
        }
        return roman.toString();
    }

    static int number(String roman) {
        int number = 0;
        for (int i = 0; i < roman.length();) {
            for (int j = 0; j < SIGNS.length; j++) {
                if (roman.startsWith(SIGNS[j], i)) {
                    number += VALUES[j];
                    i += SIGNS[j].length();
                    break;
                }
            }
        }
        return number;
    }

    static boolean isPalindrome(String text) {
        for (int i = 0, j = text.length() - 1; i < j; i++, j--) {
            if (text.charAt(i) != text.charAt(j)) return false;
        }
        return true;
    }

    public static void main(String[] arguments) {
        System.out.println(roman(1994) + " " + roman(2026) + " " + roman(3888)); // expect MCMXCIV MMXXVI MMMDCCCLXXXVIII
        int wrong = 0;
        for (int i = 1; i < 400; i++) {
            if (number(roman(i)) != i) wrong++;
        }
        System.out.println(wrong); // expect 0
        int palindromes = 0;
        for (int i = 0; i < 2000; i++) {
            if (isPalindrome("" + i)) palindromes++;
        }
        System.out.println(palindromes); // expect 119
    }
}
