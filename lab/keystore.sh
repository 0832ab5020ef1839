#!/bin/sh
# keystore.sh FOLDER: make what DDS Security needs, by openssl: an authority for identities and
# permissions, one certificate that all processes share, signed permissions, and two governances.
# "ros2" protects what the default governance of SROS2 protects (ros2/sros2 e349fcf,
# sros2/sros2/policy/defaults/dds/governance.xml): RTPS signed, all else encrypted; "discovery"
# encrypts discovery alone. Keys are of the curve that SROS2 takes. Permissions are as wide as its
# default, for topics and services. For each governance there is a file for Fast DDS and for Cyclone.
set -eu

plugins=$(dirname "$(dpkg -L libddsc0debian | grep security_auth)")
rm -rf "$1"
mkdir -p "$1"
cd "$1"
here=$(pwd)

key() { openssl genpkey -algorithm EC -pkeyopt ec_paramgen_curve:prime256v1 -out "$1" 2>/dev/null; }
sign() { openssl smime -sign -text -in "$1.xml" -out "$1.p7s" -signer ca.pem -inkey ca.key.pem; }
document() { # NAME, and the inside from the input
    { echo '<?xml version="1.0" encoding="UTF-8"?>'
      echo '<dds xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xsi:noNamespaceSchemaLocation="http://www.omg.org/spec/DDS-SECURITY/20170901/omg_shared_ca_'"$1"'.xsd">'
      cat
      echo '</dds>'; } >"$2.xml"
    sign "$2"
}

key ca.key.pem
openssl req -x509 -new -key ca.key.pem -sha256 -days 3650 -subj /CN=lab_ca -out ca.pem
key key.pem
openssl req -new -key key.pem -subj /CN=lab -out lab.csr
openssl x509 -req -in lab.csr -CA ca.pem -CAkey ca.key.pem -sha256 -days 3650 -out cert.pem 2>/dev/null

topics="<topics><topic>rt/*</topic><topic>rq/*</topic><topic>rr/*</topic></topics>"
document permissions permissions <<END
<permissions><grant name="lab"><subject_name>CN=lab</subject_name>
<validity><not_before>2020-01-01T00:00:00</not_before><not_after>2040-01-01T00:00:00</not_after></validity>
<allow_rule><domains><id>0</id></domains>
<publish>$topics</publish><subscribe>$topics</subscribe></allow_rule>
<default>DENY</default></grant></permissions>
END

governance() { # NAME, what protects RTPS, endpoints' submessages, samples, and liveliness
    document governance "$1" <<END
<domain_access_rules><domain_rule><domains><id>0</id></domains>
<allow_unauthenticated_participants>false</allow_unauthenticated_participants>
<enable_join_access_control>true</enable_join_access_control>
<discovery_protection_kind>ENCRYPT</discovery_protection_kind>
<liveliness_protection_kind>$5</liveliness_protection_kind>
<rtps_protection_kind>$2</rtps_protection_kind>
<topic_access_rules><topic_rule><topic_expression>*</topic_expression>
<enable_discovery_protection>true</enable_discovery_protection>
<enable_liveliness_protection>$6</enable_liveliness_protection>
<enable_read_access_control>true</enable_read_access_control>
<enable_write_access_control>true</enable_write_access_control>
<metadata_protection_kind>$3</metadata_protection_kind>
<data_protection_kind>$4</data_protection_kind></topic_rule></topic_access_rules>
</domain_rule></domain_access_rules>
END
    property() { echo "<property><name>dds.sec.$1</name><value>$2</value></property>"; }
    { echo '<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">'
      echo '<participant profile_name="lab" is_default_profile="true"><rtps><propertiesPolicy><properties>'
      property auth.plugin builtin.PKI-DH
      property auth.builtin.PKI-DH.identity_ca "file://$here/ca.pem"
      property auth.builtin.PKI-DH.identity_certificate "file://$here/cert.pem"
      property auth.builtin.PKI-DH.private_key "file://$here/key.pem"
      property crypto.plugin builtin.AES-GCM-GMAC
      property access.plugin builtin.Access-Permissions
      property access.builtin.Access-Permissions.permissions_ca "file://$here/ca.pem"
      property access.builtin.Access-Permissions.governance "file://$here/$1.p7s"
      property access.builtin.Access-Permissions.permissions "file://$here/permissions.p7s"
      echo '</properties></propertiesPolicy></rtps></participant></profiles>'; } >"fast_dds_$1.xml"
    plugin() { echo "<Library path=\"$plugins/libdds_security_$1.so\" initFunction=\"init_$2\" finalizeFunction=\"finalize_$2\"/>"; }
    cat >"cyclone_dds_$1.xml" <<END
<CycloneDDS><Domain Id="any"><General><AllowMulticast>spdp</AllowMulticast></General><Security>
<Authentication>$(plugin auth authentication)<IdentityCA>file:$here/ca.pem</IdentityCA>
<IdentityCertificate>file:$here/cert.pem</IdentityCertificate>
<PrivateKey>file:$here/key.pem</PrivateKey></Authentication>
<Cryptographic>$(plugin crypto crypto)</Cryptographic>
<AccessControl>$(plugin ac access_control)<PermissionsCA>file:$here/ca.pem</PermissionsCA>
<Governance>file:$here/$1.p7s</Governance>
<Permissions>file:$here/permissions.p7s</Permissions></AccessControl></Security></Domain></CycloneDDS>
END
}
governance ros2 SIGN ENCRYPT ENCRYPT ENCRYPT true
governance discovery NONE NONE NONE NONE false
