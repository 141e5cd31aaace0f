public class SumsOfDigits {
    /** Adds two numbers of any length. */
    static String sum(String left, String right) {
        StringBuilder digits = new StringBuilder();
        int carry = 0;
        for (int place = 1; place <= Math.max(left.length(), right.length()) || carry > 0; place++) {
            if (place <= left.length()) carry += left.charAt(left.length() - place) - '0';
            if (place <= right.length()) carry += right.charAt(right.length() - place) - '0';
            digits.append((char) ('0' + carry % 10));
            carry /= 10;
        }
        return reversed(digits.toString());
    }

    static String reversed(String text) {
        char[] letters = new char[text.length()];
        for (int i = 0; i < letters.length; i++) letters[i] = text.charAt(letters.length - 1 - i);
        return new String(letters);
    }

    static long digitSum(long number) {
        return number < 10 ? number : number % 10 + digitSum(number / 10);
    }

    static boolean isPalindrome(String text) {
        for (int i = 0; i < text.length() / 2; i++) {
            if (text.charAt(i) != text.charAt(text.length() - 1 - i)) return false;
        }
        return true;
    }

    public static void main(String[] arguments) {
        String last = "1";
        String next = "1";
        for (int i = 2; i < 100; i++) {
            String sum = sum(last, next);
            last = next;
            next = sum;
        }
        System.out.println(next);
        System.out.println(digitSum(Long.MAX_VALUE) + " " + digitSum(999999999999L));
        String number = "89";
        int steps = 0;
        while (!isPalindrome(number)) {
            number = sum(number, reversed(number));
            steps++;
        }
        System.out.println(number + " after " + steps);
        // expect 354224848179261915075
        // expect 88 108
        // expect 8813200023188 after 24
    }
}
