public class BigFactorials {
    static int[] multiply(int[] digits, int factor) {
        int[] product = new int[digits.length + 3];
        long carry = 0;
        int length = 0;
        for (int i = 0; i < product.length; i++) {
            long value = carry + (i < digits.length ? (long) digits[i] * factor : 0);
            product[i] = (int) (value % 1000000000);
            carry = value / 1000000000;
            if (product[i] != 0) length = i + 1;
        }
        int[] cut = new int[length];
        System.arraycopy(product, 0, cut, 0, length);
        return cut;
    }

    static String shown(int[] digits) {
        StringBuilder shown = new StringBuilder().append(digits[digits.length - 1]);
        for (int i = digits.length - 2; i >= 0; i--) {
            String part = "" + digits[i];
            for (int j = part.length(); j < 9; j++) shown.append('0');
            shown.append(part);
        }
        return shown.toString();
    }

    public static void main(String[] arguments) {
        int[] factorial = {1};
        for (int i = 2; i <= 40; i++) factorial = multiply(factorial, i);
        System.out.println(shown(factorial)); // expect 815915283247897734345611269596115894272000000000
        long small = 1;
        for (int i = 2; i <= 20; i++) small *= i;
        System.out.println(small); // expect 2432902008176640000
        double large = 1;
        for (int i = 2; i <= 20; i++) large *= i;
        System.out.println((long) large == small); // expect true
    }
}
